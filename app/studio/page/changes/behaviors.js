/** What an author does to a behaviour of the performance that is looked at: each a change that can be undone. */

import { PERFORMED, SELECTION } from "../state/performed.js";
import { slice } from "../state/slice.js";
import { changeEdits, editsOf } from "./change_edits.js";
import { editOf, withAdded, withBehavior, withoutBehavior } from "./edits.js";
import { marksOf, placeOf, wordReference } from "./references.js";

/** @import { Behavior, BehaviorEdit, Edits, Marks } from "understudy-client" */
/** @import { BehaviorChange, Made } from "./edits.js" */
/** @import { Store } from "../state/store.js" */

/** Which mark takes the whole behaviour with it, the first that it has. */
const LEADING = /** @type {const} */ (["stroke", "ready", "start"]);

/**
 * What was moved last, and how much since the performance that is shown; whoever moves it again before the service has
 * answered goes on from there.
 *
 * @typedef {Readonly<{ performance: object, edits: object, id: string, mark: string | null, later_s: number }>} Moved
 */
const MOVED = slice(/** @type {Moved | null} */ (null));

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
 * The edits with a mark of a behaviour at another time; without a mark the whole behaviour so much later.
 *
 * @param {Edits} now
 * @param {Made} made what the behaviour was seen in
 * @param {Behavior} behavior
 * @param {string | null} mark
 * @param {number} later_s
 */
export function withMoved(now, made, behavior, mark, later_s) {
  const moved = mark ?? LEADING.find((each) => behavior.sync[each] !== undefined) ?? "start";
  const time_s = Math.max(0, (behavior.sync[moved] ?? 0) + later_s);
  const before = mark ? (editOf(made, behavior)?.marks ?? {}) : shifted(made, behavior, later_s);
  /** @type {Marks} */
  const marks = { ...before, [moved]: placeOf(made.performance, time_s) };
  return withBehavior(now, made, behavior, { marks });
}

/**
 * The marks that were put somewhere, as much later as the behaviour is moved.
 *
 * @param {Made} made
 * @param {Behavior} behavior
 * @param {number} later_s
 * @returns {Marks}
 */
function shifted(made, behavior, later_s) {
  const names = Object.keys(editOf(made, behavior)?.marks ?? {});
  const places = names.flatMap((name) => {
    const time_s = behavior.sync[name];
    return time_s === undefined ? [] : [[name, placeOf(made.performance, Math.max(0, time_s + later_s))]];
  });
  return Object.fromEntries(places);
}

/**
 * @param {Store} store
 * @param {Behavior} behavior
 * @param {string | null} mark
 * @param {number} later_s
 */
export function moveBehavior(store, behavior, mark, later_s) {
  const made = madeOf(store);
  if (made) {
    const { performance } = made;
    const together_s = later_s + alreadyMoved_s(store, performance, behavior.id, mark);
    changeEdits(store, `Move ${mark ?? "all"} of ${behavior.id}`, withMoved(editsOf(store), made, behavior, mark, together_s));
    store.set(MOVED, { performance, edits: editsOf(store), id: behavior.id, mark, later_s: together_s });
  }
}

/**
 * @param {Store} store
 * @param {object} performance
 * @param {string} id
 * @param {string | null} mark
 */
function alreadyMoved_s(store, performance, id, mark) {
  const last = store.get(MOVED);
  const isSame = last?.performance === performance && last.edits === editsOf(store) && last.id === id && last.mark === mark;
  return last && isSame ? last.later_s : 0;
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
