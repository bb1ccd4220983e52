/** The tabs of the page: which of its views is shown. A view says that it is one by the class `view`. */

import { el, found } from "../dom.js";
import { slice } from "../state/slice.js";

/** @import { Store } from "../state/store.js" */

const VIEWS = Object.freeze({
  line: "Line",
  gesture_editor: "Gesture editor",
  rules: "Rules",
  table_read: "Table read",
});

/** The id of the view that is shown; set it to show another. */
export const VIEW = slice(/** @type {keyof typeof VIEWS} */ ("line"));

/**
 * @param {HTMLElement} element
 * @param {Store} store
 */
export function mountViews(element, store) {
  for (const [id, name] of Object.entries(VIEWS)) {
    const show = () => store.set(VIEW, /** @type {keyof typeof VIEWS} */ (id));
    const button = el("button", { type: "button", click: show }, [name]);
    element.append(button);
    store.watch(VIEW, (view) => {
      button.setAttribute("aria-current", view === id ? "page" : "false");
      found(document, `#${id}`, HTMLElement).hidden = view !== id;
    });
  }
}
