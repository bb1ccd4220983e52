/** Changes keys of the project: its text, its options, its edits. */

import { PROJECT } from "./project.js";

/** @import { Command } from "./history.js" */
/** @import { Project } from "./project.js" */
/** @import { Store } from "./store.js" */

/** @implements {Command} */
export class ChangeProject {
  #store;
  #after;
  #before;

  /**
   * @param {Store} store
   * @param {string} label
   * @param {Partial<Project>} keys
   * @param {Partial<Project>} [before] what the keys were, unless as now
   */
  constructor(store, label, keys, before) {
    const project = store.get(PROJECT);
    const names = /** @type {(keyof Project)[]} */ (Object.keys(keys));
    this.label = label;
    this.#store = store;
    this.#after = keys;
    this.#before = before ?? /** @type {Partial<Project>} */ (Object.fromEntries(names.map((name) => [name, project[name]])));
  }

  execute() {
    this.#store.patch(PROJECT, this.#after);
  }

  undo() {
    this.#store.patch(PROJECT, this.#before);
  }

  /**
   * One change where both are called the same and change the same keys.
   *
   * @param {Command} later
   * @returns {Command | null}
   */
  mergedWith(later) {
    const same = later instanceof ChangeProject && later.label === this.label && sameKeys(later.#after, this.#after);
    return same ? new ChangeProject(this.#store, this.label, later.#after, this.#before) : null;
  }

  toJSON() {
    return { command: "change_project", label: this.label, keys: this.#after };
  }
}

/**
 * @param {object} one
 * @param {object} other
 */
function sameKeys(one, other) {
  return Object.keys(one).sort().join() === Object.keys(other).sort().join();
}
