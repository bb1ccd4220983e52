/** Another state of the edits: what every change by hand comes to, so that one command undoes, replays and saves them all. */

import { PROJECT } from "../state/project.js";

/** @import { Edits } from "understudy-client" */
/** @import { Command } from "../state/history.js" */
/** @import { Store } from "../state/store.js" */

/** @typedef {{ command: "change_edits", label: string, before: object | null, after: object | null }} WrittenChange */

/** @implements {Command} */
export class ChangeEdits {
  #store;
  #before;
  #after;

  /**
   * @param {Store} store
   * @param {string} label what is done, and to what: changes of the same label in quick succession are one
   * @param {object | null} after
   * @param {object | null} [before] what the edits were, unless as now
   */
  constructor(store, label, after, before = store.get(PROJECT).edits) {
    this.label = label;
    this.#store = store;
    this.#before = before;
    this.#after = after;
  }

  execute() {
    this.#store.patch(PROJECT, { edits: this.#after });
  }

  undo() {
    this.#store.patch(PROJECT, { edits: this.#before });
  }

  /**
   * @param {Command} later
   * @returns {Command | null}
   */
  mergedWith(later) {
    const goesOn = later instanceof ChangeEdits && later.label === this.label;
    return goesOn ? new ChangeEdits(this.#store, this.label, later.#after, this.#before) : null;
  }

  /** @returns {WrittenChange} */
  toJSON() {
    return { command: "change_edits", label: this.label, before: this.#before, after: this.#after };
  }

  /**
   * @param {Store} store
   * @param {WrittenChange} written
   */
  static fromJSON(store, { label, before, after }) {
    return new ChangeEdits(store, label, after, before);
  }
}

/**
 * The edits of the line as it is now.
 *
 * @param {Store} store
 * @returns {Edits}
 */
export function editsOf(store) {
  return /** @type {Edits} */ (store.get(PROJECT).edits ?? NONE);
}

/** @type {Edits} */
const NONE = Object.freeze({ version: 1, words: [], behaviors: [] });

/**
 * Has the line performed with other edits.
 *
 * @param {Store} store
 * @param {string} label
 * @param {Edits} edits
 */
export function changeEdits(store, label, edits) {
  const isEmpty = !edits.words?.length && !edits.behaviors?.length;
  store.history.execute(new ChangeEdits(store, label, isEmpty ? null : edits));
}
