/**
 * The file of edits (docs/edits.md) as a value: every function makes another one. What it means is the service's affair.
 *
 * An edit of a behaviour is found again by what it is of, or where it adds: numbers of edits are those of the performance
 * that was made with them, and change when others go.
 */

import { referenceTo, withoutNothing, wordReference } from "./references.js";

/** @import { Behavior, BehaviorEdit, Edits, Performance, WordEdit } from "understudy-client" */

/** What an author changes in a behaviour; undefined leaves nothing of it. @typedef {Omit<BehaviorEdit, "of" | "add" | "on">} BehaviorChange */
/** @typedef {Omit<WordEdit, "at">} WordChange */

/** A performance, and the edits that it was made with. @typedef {Readonly<{ performance: Performance, edits: Edits }>} Made */


/**
 * The edit that made or changed a behaviour.
 *
 * @param {Made} made
 * @param {Behavior} behavior
 * @returns {BehaviorEdit | null}
 */
export function editOf({ edits }, behavior) {
  return (typeof behavior.edit === "number" && edits.behaviors?.[behavior.edit]) || null;
}

/**
 * The edits `now` with a behaviour changed beside what was changed in it before. A change whose every value is undefined
 * takes it back.
 *
 * @param {Edits} now
 * @param {Made} made what the behaviour was seen in
 * @param {Behavior} behavior
 * @param {BehaviorChange} change
 * @returns {Edits}
 */
export function withBehavior(now, made, behavior, change) {
  const before = editOf(made, behavior);
  const target = before ?? { of: referenceTo(made.performance, behavior) };
  const behaviors = [...(now.behaviors ?? [])];
  const place = placeIn(now, made, behavior, target);
  const edit = withoutNothing({ ...(behaviors[place] ?? target), ...change });
  behaviors.splice(place < 0 ? behaviors.length : place, 1, ...(saysAnything(edit) ? [edit] : []));
  return { ...now, behaviors };
}

/**
 * The edits without the one of a behaviour: it is as the choice has it, or no longer there if it was added.
 *
 * @param {Edits} now
 * @param {Made} made
 * @param {Behavior} behavior
 * @returns {Edits}
 */
export function withoutBehavior(now, made, behavior) {
  const edit = editOf(made, behavior);
  const place = edit ? placeIn(now, made, behavior, edit) : -1;
  return place < 0 ? now : { ...now, behaviors: (now.behaviors ?? []).filter((_, index) => index !== place) };
}

/**
 * @param {Edits} now
 * @param {BehaviorEdit} added
 * @returns {Edits}
 */
export function withAdded(now, added) {
  return { ...now, behaviors: [...(now.behaviors ?? []), added] };
}

/**
 * The edits with a word changed beside what was changed in it before.
 *
 * @param {Edits} now
 * @param {Performance} performance
 * @param {number} index
 * @param {WordChange} change
 * @returns {Edits}
 */
export function withWord(now, performance, index, change) {
  const at = wordReference(performance, index);
  const before = (now.words ?? []).find((each) => each.at.word === index);
  const edit = withoutNothing({ ...(before ?? { at }), ...change });
  const others = (now.words ?? []).filter((each) => each !== before);
  return { ...now, words: Object.keys(edit).length > 1 ? [...others, edit] : others };
}

/**
 * Where the edit of a behaviour is among those of now, which may have changed since the behaviour was made: by what it is
 * of, or, of what was added, by its number as long as no edit came or went. -1 where it is not.
 *
 * @param {Edits} now
 * @param {Made} made
 * @param {Behavior} behavior
 * @param {BehaviorEdit} target
 */
function placeIn(now, made, behavior, target) {
  const behaviors = now.behaviors ?? [];
  const same = behaviors.findIndex((each) => each === target || (target.of && isOf(each, target)));
  const isAligned = behaviors.length === (made.edits.behaviors?.length ?? 0);
  return same < 0 && isAligned && typeof behavior.edit === "number" ? behavior.edit : same;
}

/**
 * @param {BehaviorEdit} edit
 * @param {BehaviorEdit} target
 */
function isOf(edit, target) {
  return JSON.stringify(edit.of) === JSON.stringify(target.of);
}

/** @param {BehaviorEdit} edit */
function saysAnything(edit) {
  return Object.keys(edit).some((name) => name !== "of");
}
