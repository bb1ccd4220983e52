/**
 * The keyboard's way to change all that is selected, while the timeline has the focus: Delete deletes, M mutes, Shift+L
 * locks; with Alt the arrows move it, or the word that is selected, by 20 ms, with Shift too by 100 ms. Ctrl+C copies
 * movements, Ctrl+V pastes them at the playhead. Single marks and the edges of words are moved by their fields.
 */

import { SELECTION } from "../state/performed.js";
import { MARKED } from "../timeline/pointing.js";
import { behaviorOf, editOfSelected, lockBehavior, madeOf, selectedBehavior } from "./behaviors.js";
import { changeEdits, editsOf } from "./change_edits.js";
import { copyBehaviors, paste } from "./clipboard.js";
import { editOf, withBehavior } from "./edits.js";
import { moveBehaviors } from "./moving.js";
import { moveWord, wordOf } from "./words.js";

/** @import { Behavior } from "understudy-client" */
/** @import { Store } from "../state/store.js" */

const STEP_S = 0.02;
const LARGE_STEP_S = 0.1;

/** @type {Readonly<Record<string, (store: Store, behaviors: readonly Behavior[]) => void>>} */
const ACTIONS = Object.freeze({
  Delete: (store, behaviors) => omit(store, behaviors, "deleted"),
  m: (store, behaviors) => omit(store, behaviors, "muted"),
  L: (store, [behavior]) => behavior && lockBehavior(store, behavior, !editOfSelected(store)?.lock),
});
/** With Ctrl. @type {typeof ACTIONS} */
const COPYING = Object.freeze({
  c: (store, behaviors) => copyBehaviors(store, behaviors),
  v: (store) => paste(store),
});

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
  const [behaviors, word] = [selectedBehaviors(store), wordOf(store.get(SELECTION))];
  if (behaviors.length > 0 && later_s) {
    moveBehaviors(store, behaviors, later_s);
  } else if (word !== null && later_s) {
    moveWord(store, word, later_s);
  }
  return later_s !== 0 && (behaviors.length > 0 || word !== null);
}

/**
 * Does what a key says with the movements that are selected; whether it says something.
 *
 * @param {Store} store
 * @param {KeyboardEvent} event
 */
function act(store, event) {
  const behaviors = selectedBehaviors(store);
  const action = actionOf(event);
  const isMeant = action !== undefined && (behaviors.length > 0 || event.key === "v");
  if (isMeant) {
    action(store, behaviors);
  }
  return isMeant;
}

/** @param {KeyboardEvent} event */
function actionOf({ key, altKey, ctrlKey, metaKey, target }) {
  const isTyping = target instanceof Element && target.matches("input, select, textarea");
  return altKey || isTyping ? undefined : (ctrlKey || metaKey ? COPYING : ACTIONS)[key];
}

/**
 * Deletes or mutes a behaviour, or makes it again.
 *
 * @param {Store} store
 * @param {Behavior} behavior
 * @param {"deleted" | "muted"} omission
 */
export function changeOmission(store, behavior, omission) {
  omit(store, [behavior], omission);
}

/**
 * @param {Store} store
 * @param {readonly Behavior[]} behaviors all are made again where the first is so omitted
 * @param {"deleted" | "muted"} omission
 */
function omit(store, behaviors, omission) {
  const made = madeOf(store);
  const [first] = behaviors;
  if (!made || !first) {
    return;
  }
  const isOmitted = editOf(made, first)?.omit === omission;
  const label = isOmitted ? "Make" : omission === "deleted" ? "Delete" : "Mute";
  const change = isOmitted ? { omit: undefined } : { ...NOTHING, omit: omission };
  const edits = behaviors.reduce((now, behavior) => withBehavior(now, made, behavior, change), editsOf(store));
  changeEdits(store, `${label} ${behaviors.map(({ id }) => id).join(", ")}`, edits);
}

const NOTHING = Object.freeze({ lexeme: undefined, hand: undefined, amount: undefined, direction: undefined, marks: undefined, lock: undefined });

/** @param {KeyboardEvent} event */
function laterBy_s({ key, altKey, shiftKey }) {
  const way = key === "ArrowLeft" ? -1 : key === "ArrowRight" ? 1 : 0;
  return altKey ? way * (shiftKey ? LARGE_STEP_S : STEP_S) : 0;
}
