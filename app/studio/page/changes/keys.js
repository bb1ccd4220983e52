/**
 * The keyboard's way to change what is selected, while the timeline has the focus: Delete deletes, M mutes, L locks;
 * with Alt the arrows move it by 20 ms, with Shift too by 100 ms. Single marks are moved by their fields in the panel.
 */

import { lockBehavior, changeBehavior, editOfSelected, moveBehavior, selectedBehavior } from "./behaviors.js";

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
    const behavior = selectedBehavior(store);
    const act = behavior && (movement(event) ?? action(event));
    if (act) {
      event.preventDefault();
      event.stopPropagation();
      act(store, behavior);
    }
  });
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
function movement({ key, altKey, shiftKey }) {
  const way = key === "ArrowLeft" ? -1 : key === "ArrowRight" ? 1 : 0;
  const later_s = way * (shiftKey ? LARGE_STEP_S : STEP_S);
  return altKey && way
    ? (/** @type {Store} */ store, /** @type {Behavior} */ behavior) => moveBehavior(store, behavior, null, later_s)
    : null;
}

/** @param {KeyboardEvent} event */
function action({ key, altKey, ctrlKey, metaKey }) {
  return altKey || ctrlKey || metaKey ? null : (ACTIONS[key.length === 1 ? key.toLowerCase() : key] ?? null);
}
