/** The selection stays on its behaviour when the line is performed again, though ids are given anew in order of time. */

import { PERFORMED, SELECTION } from "../state/performed.js";
import { behaviorOf, madeOf } from "./behaviors.js";
import { editOf } from "./edits.js";
import { referenceTo } from "./references.js";

/** @import { Behavior, BehaviorEdit } from "understudy-client" */
/** @import { Made } from "./edits.js" */
/** @import { Store } from "../state/store.js" */

/** @param {Store} store */
export function keepSelected(store) {
  let before = madeOf(store);
  store.watch(PERFORMED, () => {
    const [was, now] = [before, madeOf(store)];
    before = now;
    const behavior = behaviorOf(was, store.get(SELECTION));
    if (was && now && behavior) {
      store.set(SELECTION, successor(was, now, behavior)?.id ?? null);
    }
  });
}

/**
 * The behaviour of another performance that is the same: by its edit, else by what it is, the nearest of several.
 *
 * @param {Made} was
 * @param {Made} now
 * @param {Behavior} behavior
 * @returns {Behavior | null}
 */
export function successor(was, now, behavior) {
  const target = JSON.stringify(editOf(was, behavior)?.of ?? referenceTo(was.performance, behavior));
  const edited = now.performance.behaviors.find((each) => isEdited(now, each, target) || isAdded(was, now, behavior, each));
  const alike = now.performance.behaviors.filter(({ kind, lexeme, first }) => isAlike(behavior, { kind, lexeme, first }));
  const start_s = behavior.sync["start"] ?? 0;
  const near = [...alike].sort((a, b) => Math.abs((a.sync["start"] ?? 0) - start_s) - Math.abs((b.sync["start"] ?? 0) - start_s));
  return edited ?? near[0] ?? null;
}

/**
 * @param {Made} made
 * @param {Behavior} behavior
 * @param {string} target what it is of, as JSON
 */
function isEdited(made, behavior, target) {
  const edit = editOf(made, behavior);
  return edit?.of !== undefined && JSON.stringify(edit.of) === target;
}

/**
 * Whether both were added by the same edit.
 *
 * @param {Made} was
 * @param {Made} now
 * @param {Behavior} behavior
 * @param {Behavior} other
 */
function isAdded(was, now, behavior, other) {
  const [one, same] = [editOf(was, behavior), editOf(now, other)];
  return one?.add !== undefined && isSameAddition(one, same) && behavior.edit === other.edit;
}

/**
 * @param {BehaviorEdit} one
 * @param {BehaviorEdit | null} other
 */
function isSameAddition(one, other) {
  return one.add === other?.add && JSON.stringify(one.on) === JSON.stringify(other?.on);
}

/**
 * @param {Behavior} one
 * @param {Pick<Behavior, "kind" | "lexeme" | "first">} other
 */
function isAlike(one, { kind, lexeme, first }) {
  return one.kind === kind && one.lexeme === lexeme && one.first === first;
}
