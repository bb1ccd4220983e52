/** The gestures that are edited, as values, and which of them, which of its frames and whose arm is looked at. */

import { slice } from "../state/slice.js";

/** @import { CheckedGestures, GestureLanguage, GestureValues } from "understudy-client" */
/** @import { Command } from "../state/history.js" */
/** @import { Store } from "../state/store.js" */

/** The gestures of a file and the place of the one that is edited. @typedef {Readonly<{ gestures: readonly GestureValues[], index: number }>} Edited */

/** A gesture to begin with: the hand rises before the chest. @type {GestureValues} */
export const FIRST = {
  class: "beat",
  name: "own_gesture",
  duration_s: 1.5,
  categories: ["OWN_GESTURE"],
  levels: {
    low: { amplitude: 0.92, tempo: 0.97, fluidity: 0.7, power: 0.3, repetition: 0.3 },
    medium: { amplitude: 1, tempo: 1, fluidity: 0.5, power: 0.5, repetition: 0.35 },
    high: { amplitude: 1.2, tempo: 1.2, fluidity: 0.35, power: 0.75, repetition: 0.65 },
  },
  frames: [
    { time: 0.25, type: "stroke_start", leading: { place: { x: "XC", y: "YCC", z: "ZMiddle" } } },
    { time: 0.6, type: "stroke_end", leading: { place: { x: "XC", y: "YUpperC", z: "ZMiddle" } } },
  ],
};

export const EDITED = slice(/** @type {Edited} */ ({ gestures: [FIRST], index: 0 }));

/** The place of the frame that is looked at. */
export const FRAME = slice(0);

/** Whose part of the frame: the leading arm's, which is the right, or the other's in gestures of both. */
export const ARM = slice(/** @type {"leading" | "other"} */ ("leading"));

/** The words of the language; null until the service has told them. */
export const LANGUAGE = slice(/** @type {GestureLanguage | null} */ (null));

/** What the service said last about the text: its mistakes, and poses that the body cannot take. */
export const CHECKED = slice(/** @type {CheckedGestures | null} */ (null));

/**
 * The gesture that is edited.
 *
 * @param {Edited} edited
 * @returns {GestureValues}
 */
export function gestureOf({ gestures, index }) {
  return gestures[index] ?? gestures[0] ?? FIRST;
}

/** @implements {Command} */
export class ChangeGestures {
  #store;
  #before;
  #after;

  /**
   * @param {Store} store
   * @param {string} label
   * @param {Edited} after
   * @param {Edited} [before] what there was, unless what is now
   */
  constructor(store, label, after, before = store.get(EDITED)) {
    this.label = label;
    this.#store = store;
    this.#after = after;
    this.#before = before;
  }

  execute() {
    this.#store.set(EDITED, this.#after);
  }

  undo() {
    this.#store.set(EDITED, this.#before);
  }

  /**
   * @param {Command} later
   * @returns {Command | null}
   */
  mergedWith(later) {
    const same = later instanceof ChangeGestures && later.label === this.label;
    return same ? new ChangeGestures(this.#store, this.label, later.#after, this.#before) : null;
  }

  toJSON() {
    return { command: "change_gestures", label: this.label, ...this.#after };
  }
}

/**
 * Changes the gesture that is edited, so that it can be undone.
 *
 * @param {Store} store
 * @param {string} label
 * @param {(gesture: GestureValues) => GestureValues} change
 */
export function changeGesture(store, label, change) {
  const edited = store.get(EDITED);
  const changed = change(gestureOf(edited));
  const gestures = edited.gestures.map((each, index) => (index === edited.index ? changed : each));
  store.history.execute(new ChangeGestures(store, label, { ...edited, gestures }));
}
