/** Behaviours at other times: one of their marks, or all of it, with whatever moves along. */

import { slice } from "../state/slice.js";
import { LOOKS } from "../timeline/looks.js";
import { madeOf, selectedBehaviors } from "./behaviors.js";
import { changeEdits, editsOf } from "./change_edits.js";
import { editOf, withBehavior } from "./edits.js";
import { placeOf } from "./references.js";

/** @import { Behavior, BehaviorEdit, Edits, Marks } from "understudy-client" */
/** @import { Made } from "./edits.js" */
/** @import { Store } from "../state/store.js" */

/** Which mark takes the whole behaviour with it, the first that it has. */
const LEADING = /** @type {const} */ (["stroke", "ready", "start"]);

/**
 * What was moved last, and how much since the performance that is shown; whoever moves it again before the service has
 * answered goes on from there.
 *
 * @typedef {Readonly<{ performance: object, edits: object, id: string, later_s: number }>} Moved
 */
const MOVED = slice(/** @type {Moved | null} */ (null));

/**
 * What moves with behaviours: everything that is selected, if they are; while the timeline ripples also what begins later in
 * their rows.
 *
 * @param {Store} store
 * @param {readonly Behavior[]} behaviors
 */
export function movedWith(store, behaviors) {
  const selected = selectedBehaviors(store);
  const moved = behaviors.some(({ id }) => selected.some((each) => each.id === id)) ? selected : behaviors;
  if (!store.get(LOOKS).ripple) {
    return moved;
  }
  const all = madeOf(store)?.performance.behaviors.filter(({ kept }) => kept) ?? [];
  const begins_s = (/** @type {Behavior} */ { sync }) => Math.min(...Object.values(sync));
  const isLater = (/** @type {Behavior} */ each) => moved.some((one) => one.kind === each.kind && begins_s(one) < begins_s(each));
  return [...moved, ...all.filter((each) => !moved.some(({ id }) => id === each.id) && isLater(each))];
}

/**
 * The edits with behaviours so much later.
 *
 * @param {Edits} now
 * @param {Made} made
 * @param {readonly Behavior[]} behaviors
 * @param {number} later_s
 */
export function withAllMoved(now, made, behaviors, later_s) {
  return behaviors.reduce((edits, behavior) => withMoved(edits, made, behavior, null, later_s), now);
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
  return withBehavior(now, made, behavior, { ...chosenBy(behavior), marks });
}

/**
 * What of a gesture that was moved stays as it was seen: what it is, and the hand that makes it.
 *
 * @param {Behavior} behavior
 * @returns {Pick<BehaviorEdit, "lexeme" | "hand">}
 */
function chosenBy({ kind, lexeme, hand }) {
  return kind === "gesture" && hand ? { lexeme, hand: /** @type {BehaviorEdit["hand"]} */ (hand) } : {};
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
 * @param {readonly Behavior[]} behaviors
 * @param {number} later_s
 */
export function moveBehaviors(store, behaviors, later_s) {
  const made = madeOf(store);
  if (made) {
    const { performance } = made;
    const id = behaviors.map((each) => each.id).join(", ");
    const together_s = later_s + alreadyMoved_s(store, performance, id);
    changeEdits(store, `Move all of ${id}`, withAllMoved(editsOf(store), made, movedWith(store, behaviors), together_s));
    store.set(MOVED, { performance, edits: editsOf(store), id, later_s: together_s });
  }
}

/**
 * Has a mark of a behaviour at a time.
 *
 * @param {Store} store
 * @param {Behavior} behavior
 * @param {string} mark
 * @param {number} time_s
 */
export function putMark(store, behavior, mark, time_s) {
  const made = madeOf(store);
  if (made) {
    const later_s = time_s - (behavior.sync[mark] ?? 0);
    changeEdits(store, `Move ${mark} of ${behavior.id}`, withMoved(editsOf(store), made, behavior, mark, later_s));
  }
}

/**
 * @param {Store} store
 * @param {object} performance
 * @param {string} id
 */
function alreadyMoved_s(store, performance, id) {
  const last = store.get(MOVED);
  const isSame = last?.performance === performance && last.edits === editsOf(store) && last.id === id;
  return last && isSame ? last.later_s : 0;
}
