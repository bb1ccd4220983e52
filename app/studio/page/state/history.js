/**
 * What the author did, to be undone and done again without end.
 *
 * Every change is a command: it can be executed, undone, and written as JSON. A command that goes on with the one before
 * (the same drag, the same field being typed) takes its place if both come within half a second.
 */

import { slice } from "./slice.js";

/** @import { Store } from "./store.js" */

/**
 * A change that an author makes. `label` says it to people ("Move gesture1"). `mergedWith(later)` is the one command that
 * does both, or null where they do not belong together; it has been executed already.
 *
 * @typedef {object} Command
 * @property {string} label
 * @property {() => void} execute
 * @property {() => void} undo
 * @property {() => object} toJSON
 * @property {(later: Command) => Command | null} [mergedWith]
 */

/**
 * What can be undone and done again, by its label; null where nothing can.
 *
 * @typedef {Readonly<{ undo: string | null, redo: string | null }>} Doable
 */

const MERGED_WITHIN_MS = 500;

/** What the buttons for it show. */
export const DOABLE = slice(/** @type {Doable} */ ({ undo: null, redo: null }));

/** The commands that were executed, and those that were undone. */
export class History {
  /** @type {Command[]} */
  #done = [];
  /** @type {Command[]} */
  #undone = [];
  #lastMs = -Infinity;
  #store;
  #now;

  /**
   * @param {Store} store
   * @param {() => number} now milliseconds
   */
  constructor(store, now = () => performance.now()) {
    this.#store = store;
    this.#now = now;
  }

  /**
   * Executes a command; what was undone before cannot be done again.
   *
   * @param {Command} command
   */
  execute(command) {
    command.execute();
    const last = this.#done.at(-1);
    const together = this.#now() - this.#lastMs < MERGED_WITHIN_MS ? (last?.mergedWith?.(command) ?? null) : null;
    if (together) {
      this.#done.pop();
    }
    this.#done.push(together ?? command);
    this.#undone = [];
    this.#lastMs = this.#now();
    this.#tell();
  }

  undo() {
    this.#move(this.#done, this.#undone, (command) => command.undo());
  }

  redo() {
    this.#move(this.#undone, this.#done, (command) => command.execute());
  }

  /** Forgets everything, as when another line is opened. */
  clear() {
    this.#done = [];
    this.#undone = [];
    this.#tell();
  }

  /** What was done, the first first. */
  toJSON() {
    return this.#done.map((command) => command.toJSON());
  }

  /**
   * @param {Command[]} from
   * @param {Command[]} to
   * @param {(command: Command) => void} act
   */
  #move(from, to, act) {
    const command = from.pop();
    if (command) {
      act(command);
      to.push(command);
      this.#lastMs = -Infinity;
      this.#tell();
    }
  }

  #tell() {
    const labels = { undo: this.#done.at(-1)?.label ?? null, redo: this.#undone.at(-1)?.label ?? null };
    this.#store.set(DOABLE, labels);
  }
}
