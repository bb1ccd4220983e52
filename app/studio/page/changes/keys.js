/**
 * The keyboard's way to change all that is selected, while the timeline has the focus: Delete deletes, M mutes, Shift+L
 * locks; with Alt the arrows move it, or the word that is selected, by 20 ms, with Shift too by 100 ms, and [ and ] begin and
 * end it at the playhead. Ctrl+C copies movements, Ctrl+V pastes them at the playhead. R has what comes later move along, or
 * no longer. Single marks and the edges of words are moved by their fields.
 */

import { SELECTION, TIME_S } from "../state/performed.js";
import { toggleLook } from "../timeline/looks.js";
import { editOfSelected, lockBehavior, madeOf, selectedBehaviors } from "./behaviors.js";
import { changeEdits, editsOf } from "./change_edits.js";
import { copyBehaviors, paste } from "./clipboard.js";
import { editOf, withBehavior } from "./edits.js";
import { moveBehaviors, putMark } from "./moving.js";
import { moveWord, wordOf } from "./words.js";

/** @import { Behavior } from "understudy-client" */
/** @import { Store } from "../state/store.js" */

const STEP_S = 0.02;
const LARGE_STEP_S = 0.1;

/** @type {Readonly<Record<string, (store: Store, behaviors: readonly Behavior[]) => void>>} */
const ACTIONS = Object.freeze({
  Delete: (store, behaviors) => omit(store, behaviors, "deleted"),
  m: (store, behaviors) => omit(store, behaviors, "muted"),
  r: (store) => toggleLook(store, "ripple"),
  L: (store, [behavior]) => behavior && lockBehavior(store, behavior, !editOfSelected(store)?.lock),
});
/** With Alt, where the key is on the keyboard: which mark is put where the playhead is. @type {Readonly<Record<string, string>>} */
const TRIMMED = Object.freeze({ BracketLeft: "start", BracketRight: "end" });
/** With Ctrl. @type {typeof ACTIONS} */
const COPYING = Object.freeze({
  c: (store, behaviors) => copyBehaviors(store, behaviors),
  v: (store) => paste(store),
});

/** Keys that need nothing to be selected. */
const FREE = new Set(["v", "r"]);

/**
 * @param {HTMLElement} timeline
 * @param {Store} store
 */
export function followKeys(timeline, store) {
  timeline.addEventListener("keydown", (event) => {
    if (move(store, laterBy_s(event)) || trim(store, event) || act(store, event)) {
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
 * Has the movement that is selected begin or end at the playhead; whether a key says so.
 *
 * @param {Store} store
 * @param {KeyboardEvent} event
 */
function trim(store, { altKey, code }) {
  const [mark, [behavior]] = [altKey ? TRIMMED[code] : undefined, selectedBehaviors(store)];
  if (mark && behavior?.kept) {
    putMark(store, behavior, mark, store.get(TIME_S));
  }
  return mark !== undefined;
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
  const isMeant = action !== undefined && (behaviors.length > 0 || FREE.has(event.key));
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
