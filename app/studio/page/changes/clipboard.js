/** Movements that were copied, and are added where the playhead is, as far apart as they were. */

import { TIME_S } from "../state/performed.js";
import { slice } from "../state/slice.js";
import { madeOf } from "./behaviors.js";
import { changeEdits, editsOf } from "./change_edits.js";
import { withAdded } from "./edits.js";
import { placeOf, withoutNothing } from "./references.js";

/** @import { Behavior, BehaviorEdit, Performance } from "understudy-client" */
/** @import { Store } from "../state/store.js" */

const LEADING = /** @type {const} */ (["stroke", "ready", "start"]);

export const COPIED = slice(/** @type {readonly Behavior[]} */ ([]));

/**
 * @param {Store} store
 * @param {readonly Behavior[]} behaviors
 */
export function copyBehaviors(store, behaviors) {
  store.set(COPIED, [...behaviors].sort((one, other) => leading(one)[1] - leading(other)[1]));
}

/** @param {Store} store */
export function paste(store) {
  const made = madeOf(store);
  const copied = store.get(COPIED);
  const [first] = copied;
  if (made && first) {
    const later_s = store.get(TIME_S) - leading(first)[1];
    const edits = copied.reduce((now, behavior) => withAdded(now, pasted(made.performance, behavior, later_s)), editsOf(store));
    changeEdits(store, `Paste ${copied.map(({ id }) => id).join(", ")}`, edits);
  }
}

/**
 * The edit that adds a movement like another, so much later.
 *
 * @param {Performance} performance
 * @param {Behavior} behavior
 * @param {number} later_s
 * @returns {BehaviorEdit}
 */
export function pasted(performance, behavior, later_s) {
  const { kind, lexeme, hand, amount, direction } = behavior;
  const [mark, time_s] = leading(behavior);
  const place = placeOf(performance, Math.max(0, time_s + later_s));
  return /** @type {BehaviorEdit} */ (
    withoutNothing({
      add: kind,
      on: place.at,
      lexeme,
      hand: kind === "gesture" ? hand : undefined,
      amount: kind === "posture" || kind === "gaze" ? undefined : amount,
      direction: kind === "gaze" ? direction : undefined,
      marks: { [mark]: place },
    })
  );
}

/**
 * The mark that a movement is put by, and when it is.
 *
 * @param {Behavior} behavior
 * @returns {readonly [string, number]}
 */
function leading({ sync }) {
  const mark = LEADING.find((each) => sync[each] !== undefined) ?? "start";
  return [mark, sync[mark] ?? 0];
}
