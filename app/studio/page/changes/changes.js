/** Mounts the panel; nothing is in it yet. */

/** @import { Service } from "../service/service.js" */
/** @import { Store } from "../state/store.js" */

/**
 * @param {HTMLElement} element
 * @param {Store} _store
 * @param {Service} _service
 */
export function mountChanges(element, _store, _service) {
  element.hidden = true;
}
