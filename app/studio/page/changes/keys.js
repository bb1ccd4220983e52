/**
 * The keyboard's way to change what is selected, while the timeline has the focus: Delete deletes, M mutes, L locks;
 * with Alt the arrows move it, or the word that is selected, by 20 ms, with Shift too by 100 ms. Single marks and the
 * edges of words are moved by their fields in the panel.
 */

import { SELECTION } from "../state/performed.js";
import { changeBehavior, editOfSelected, lockBehavior, selectedBehavior } from "./behaviors.js";
import { moveBehavior } from "./moving.js";
import { moveWord, wordOf } from "./words.js";

/** @import { Behavior } from "understudy-client" */
/** @import { Store } from "../state/store.js" */

const STEP_S = 0.02;
const LARGE_STEP_S = 0.1;

/** @type {Readonly<Record<string, (store: Store, behavior: Behavior) => void>>} */
const ACTIONS = Object.freeze({
  Delete: (store, behavior) => changeOmission(store, behavior, "deleted"),
  m: (store, behavior) => changeOmission(store, behavior, "muted"),
  l: (store, behavior) => lockBehavior(store, behavior, !editOfSelected(store)?.lock),
});

/**
 * @param {HTMLElement} timeline
 * @param {Store} store
 */
export function followKeys(timeline, store) {
  timeline.addEventListener("keydown", (event) => {
    if (move(store, laterBy_s(event)) || act(store, event)) {
      event.preventDefault();
      event.stopPropagation();
    }
  });
}

/**
 * Moves what is selected; whether there is something to move.
 *
 * @param {Store} store
 * @param {number} later_s
 */
function move(store, later_s) {
  const [behavior, word] = [selectedBehavior(store), wordOf(store.get(SELECTION))];
  if (behavior && later_s) {
    moveBehavior(store, behavior, null, later_s);
  } else if (word !== null && later_s) {
    moveWord(store, word, later_s);
  }
  return later_s !== 0 && (behavior !== null || word !== null);
}

/**
 * Does what a key says with the behaviour that is selected; whether it says something.
 *
 * @param {Store} store
 * @param {KeyboardEvent} event
 */
function act(store, { key, altKey, ctrlKey, metaKey }) {
  const behavior = selectedBehavior(store);
  const action = altKey || ctrlKey || metaKey ? undefined : ACTIONS[key.length === 1 ? key.toLowerCase() : key];
  if (behavior && action) {
    action(store, behavior);
  }
  return behavior !== null && action !== undefined;
}

/**
 * Deletes or mutes a behaviour, or makes it again.
 *
 * @param {Store} store
 * @param {Behavior} behavior
 * @param {"deleted" | "muted"} omission
 */
export function changeOmission(store, behavior, omission) {
  const isOmitted = editOfSelected(store)?.omit === omission;
  const nothing = { lexeme: undefined, hand: undefined, amount: undefined, direction: undefined, marks: undefined, lock: undefined };
  const label = isOmitted ? "Make" : omission === "deleted" ? "Delete" : "Mute";
  changeBehavior(store, label, behavior, isOmitted ? { omit: undefined } : { ...nothing, omit: omission });
}

/** @param {KeyboardEvent} event */
function laterBy_s({ key, altKey, shiftKey }) {
  const way = key === "ArrowLeft" ? -1 : key === "ArrowRight" ? 1 : 0;
  return altKey ? way * (shiftKey ? LARGE_STEP_S : STEP_S) : 0;
}
