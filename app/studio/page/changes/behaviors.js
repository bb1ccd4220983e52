/** What an author does to a behaviour of the performance that is looked at: each a change that can be undone. */

import { PERFORMED, SELECTION } from "../state/performed.js";
import { MARKED } from "../timeline/selecting.js";
import { changeEdits, editsOf } from "./change_edits.js";
import { editOf, withAdded, withBehavior, withoutBehavior } from "./edits.js";
import { marksOf, wordReference } from "./references.js";

/** @import { Behavior, BehaviorEdit, Edits } from "understudy-client" */
/** @import { BehaviorChange, Made } from "./edits.js" */
/** @import { Store } from "../state/store.js" */

/**
 * The performance that is shown with the edits it was made with; null before there is one.
 *
 * @param {Store} store
 * @returns {Made | null}
 */
export function madeOf(store) {
  const line = store.get(PERFORMED);
  return line && { performance: line.performance, edits: /** @type {Edits} */ (line.edits ?? {}) };
}

/**
 * The behaviour that is selected, if one is.
 *
 * @param {Store} store
 */
export function selectedBehavior(store) {
  return behaviorOf(madeOf(store), store.get(SELECTION));
}

/**
 * The movements that are selected, the one that the inspector shows first.
 *
 * @param {Store} store
 */
export function selectedBehaviors(store) {
  const made = madeOf(store);
  return [selectedBehavior(store), ...store.get(MARKED).map((id) => behaviorOf(made, id))].filter((each) => each !== null);
}

/**
 * @param {Made | null} made
 * @param {string | null} id
 * @returns {Behavior | null}
 */
export function behaviorOf(made, id) {
  return made?.performance.behaviors.find((each) => each.id === id) ?? null;
}

/**
 * Changes a behaviour of the performance that is shown.
 *
 * @param {Store} store
 * @param {string} label
 * @param {Behavior} behavior
 * @param {BehaviorChange} change
 */
export function changeBehavior(store, label, behavior, change) {
  const made = madeOf(store);
  if (made) {
    changeEdits(store, `${label} ${behavior.id}`, withBehavior(editsOf(store), made, behavior, change));
  }
}

/**
 * Takes back all that was changed in a behaviour.
 *
 * @param {Store} store
 * @param {Behavior} behavior
 */
export function revertBehavior(store, behavior) {
  const made = madeOf(store);
  if (made) {
    changeEdits(store, `Take back ${behavior.id}`, withoutBehavior(editsOf(store), made, behavior));
  }
}

/**
 * Has a behaviour made as it is now whatever else is chosen, or no longer so.
 *
 * @param {Store} store
 * @param {Behavior} behavior
 * @param {boolean} lock
 */
export function lockBehavior(store, behavior, lock) {
  const made = madeOf(store);
  if (made) {
    changeBehavior(store, lock ? "Lock" : "Unlock", behavior, lock ? lockOf(made, behavior) : { lock: undefined });
  }
}

/**
 * A behaviour as it is now, in words of edits.
 *
 * @param {Made} made
 * @param {Behavior} behavior
 * @returns {BehaviorChange}
 */
function lockOf({ performance }, behavior) {
  const { kind, lexeme, hand, amount, direction } = behavior;
  const sized = kind !== "posture" && kind !== "gaze" && typeof amount === "number";
  return {
    lexeme,
    lock: true,
    marks: marksOf(performance, behavior),
    ...(kind === "gesture" && hand ? { hand: /** @type {BehaviorEdit["hand"]} */ (hand) } : {}),
    ...(sized ? { amount } : {}),
    ...(kind === "gaze" && direction ? { direction: /** @type {BehaviorEdit["direction"]} */ (direction) } : {}),
  };
}

/**
 * @param {Store} store
 * @param {number} word
 * @param {BehaviorEdit["add"]} channel
 * @param {string} lexeme
 */
export function addBehavior(store, word, channel, lexeme) {
  const made = madeOf(store);
  if (made) {
    const edit = { add: channel, on: wordReference(made.performance, word), lexeme };
    changeEdits(store, `Add ${lexeme}`, withAdded(editsOf(store), edit));
  }
}

/**
 * What was changed in the behaviour that is selected.
 *
 * @param {Store} store
 */
export function editOfSelected(store) {
  const [made, behavior] = [madeOf(store), selectedBehavior(store)];
  return made && behavior ? editOf(made, behavior) : null;
}
