/**
 * What an author chose stays as it was chosen, whatever the performer would now do there: a replaced gesture is locked
 * with its stroke where it is, and with the hand that makes it as soon as the service has told which one that is.
 */

import { PERFORMED } from "../state/performed.js";
import { PROJECT } from "../state/project.js";
import { changeBehavior, madeOf } from "./behaviors.js";
import { editOf } from "./edits.js";
import { placeOf, withoutNothing } from "./references.js";

/** @import { Behavior, BehaviorEdit, Edits } from "understudy-client" */
/** @import { Made } from "./edits.js" */
/** @import { Store } from "../state/store.js" */

/**
 * Has another gesture made in place of one.
 *
 * @param {Store} store
 * @param {Behavior} behavior
 * @param {string} lexeme
 */
export function replaceGesture(store, behavior, lexeme) {
  const made = madeOf(store);
  const stroke_s = behavior.sync["stroke"];
  if (made) {
    const stroke = stroke_s === undefined ? {} : { stroke: placeOf(made.performance, stroke_s) };
    const marks = { ...editOf(made, behavior)?.marks, ...stroke };
    changeBehavior(store, "Movement of", behavior, { lexeme, hand: undefined, marks, lock: true });
  }
}

/**
 * Puts the hand into the edits of gestures that were chosen, for each performance that shows it. No change of its own to
 * be undone: it belongs to the choice.
 *
 * @param {Store} store
 */
export function keepChosenHands(store) {
  store.watch(PERFORMED, (line) => {
    const made = madeOf(store);
    const edits = made && line?.edits === store.get(PROJECT).edits ? withHands(made) : null;
    if (edits && edits !== made?.edits) {
      store.patch(PROJECT, { edits });
    }
  });
}

/**
 * The edits of a performance, with the hand that is seen in it for each gesture that was chosen without one; the same
 * where all have theirs.
 *
 * @param {Made} made
 * @returns {Edits}
 */
export function withHands({ performance, edits }) {
  const chosen = new Map(performance.behaviors.filter(isGesture).map(({ edit, hand }) => [edit, /** @type {BehaviorEdit["hand"]} */ (hand)]));
  const handOf = (/** @type {BehaviorEdit} */ each, /** @type {number} */ index) => (each.lexeme && !each.hand ? chosen.get(index) : undefined);
  const behaviors = edits.behaviors ?? [];
  return behaviors.some(handOf)
    ? { ...edits, behaviors: behaviors.map((each, index) => withoutNothing({ ...each, hand: handOf(each, index) ?? each.hand })) }
    : edits;
}

/**
 * A gesture that is made, and by which hand.
 *
 * @param {Behavior} behavior
 */
function isGesture({ kind, kept, hand }) {
  return kind === "gesture" && kept && Boolean(hand);
}
