/**
 * What the page knows, in slices that panels read, set and watch; panels talk to each other through it alone.
 *
 * A slice is a constant of the room that owns it (`slice(initial)`), so whoever uses it imports it and its type. Values
 * are frozen: to change one, set another. Watchers are called at once, in the order in which they began to watch, and
 * only where the value is another one.
 */

import { History } from "./history.js";
import { frozen } from "./slice.js";

/**
 * @template Value
 * @typedef {import("./slice.js").Slice<Value>} Slice
 */

/** The values of all slices, and the history of what the author changed. */
export class Store {
  /** @type {Map<Slice<any>, unknown>} */
  #values = new Map();
  /** @type {Map<Slice<any>, Set<(value: any) => void>>} */
  #watchers = new Map();

  constructor() {
    /** What the author did; see history.js. */
    this.history = new History(this);
  }

  /**
   * @template Value
   * @param {Slice<Value>} of
   * @returns {Value}
   */
  get(of) {
    return this.#values.has(of) ? /** @type {Value} */ (this.#values.get(of)) : of.initial;
  }

  /**
   * @template Value
   * @param {Slice<Value>} of
   * @param {Value} value
   */
  set(of, value) {
    if (Object.is(this.get(of), value)) {
      return;
    }
    this.#values.set(of, frozen(value));
    for (const told of [...(this.#watchers.get(of) ?? [])]) {
      told(value);
    }
  }

  /**
   * Sets some keys of an object.
   *
   * @template {object} Value
   * @param {Slice<Value>} of
   * @param {Partial<Value>} keys
   */
  patch(of, keys) {
    this.set(of, { ...this.get(of), ...keys });
  }

  /**
   * Calls `watcher` now and after each change, until what is returned is called.
   *
   * @template Value
   * @param {Slice<Value>} of
   * @param {(value: Value) => void} watcher
   */
  watch(of, watcher) {
    const watchers = this.#watchers.get(of) ?? new Set();
    this.#watchers.set(of, watchers.add(watcher));
    watcher(this.get(of));
    return () => watchers.delete(watcher);
  }
}
