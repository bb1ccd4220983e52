/** How edits name behaviours, words and moments, so that they are found again when the line is performed anew. */

/** @import { Behavior, BehaviorReference, Marks, Performance } from "understudy-client" */

/**
 * What means this behaviour when the line is performed again.
 *
 * @param {Performance} performance
 * @param {Behavior} behavior
 * @returns {BehaviorReference}
 */
export function referenceTo({ words, functions, moments }, behavior) {
  const word = words[behavior.first];
  const shown = functions.find(({ id }) => id === behavior.function);
  const moment = moments.find(({ id }) => id === behavior.moment);
  return withoutNothing({
    channel: /** @type {BehaviorReference["channel"]} */ (behavior.kind),
    at: { word: behavior.first, text: word?.text },
    function: shown?.class,
    family: moment?.families[0],
    lexeme: behavior.lexeme,
    offset_s: rounded((behavior.sync["start"] ?? 0) - (word?.start_s ?? 0)),
  });
}

/**
 * A moment, told from the nearest edge of a word, so that it goes with the word.
 *
 * @param {Performance} performance
 * @param {number} time_s
 * @returns {NonNullable<Marks["start"]>}
 */
export function placeOf({ words }, time_s) {
  const edges = words.flatMap(({ index, start_s, end_s }) => [
    { index, edge: /** @type {const} */ ("start"), at_s: start_s },
    { index, edge: /** @type {const} */ ("end"), at_s: end_s },
  ]);
  const spoken = edges.flatMap((each) => (typeof each.at_s === "number" ? [{ ...each, at_s: each.at_s }] : []));
  const [first, ...others] = spoken;
  const nearest = others.reduce((best, each) => (farFrom(time_s, each) < farFrom(time_s, best) ? each : best), first ?? NOWHERE);
  const { index, edge, at_s } = nearest;
  return { at: { word: index, text: words[index]?.text }, edge, offset_s: rounded(time_s - at_s) };
}

const NOWHERE = Object.freeze({ index: 0, edge: /** @type {const} */ ("start"), at_s: 0 });

/**
 * All marks of a behaviour where they are now, as a lock wants them.
 *
 * @param {Performance} performance
 * @param {Behavior} behavior
 * @returns {Marks}
 */
export function marksOf(performance, { sync }) {
  return Object.fromEntries(Object.entries(sync).map(([mark, time_s]) => [mark, placeOf(performance, time_s)]));
}

/**
 * @param {Performance} performance
 * @param {number} index
 */
export function wordReference({ words }, index) {
  return { word: index, text: words[index]?.text };
}

/**
 * @param {number} time_s
 * @param {{ at_s: number }} edge
 */
function farFrom(time_s, { at_s }) {
  return Math.abs(time_s - at_s);
}

/** @param {number} time_s */
function rounded(time_s) {
  return Math.round(1000 * time_s) / 1000;
}

/**
 * The keys that say something.
 *
 * @template {object} Value
 * @param {Value} value
 * @returns {Value}
 */
export function withoutNothing(value) {
  const told = Object.entries(value).filter(([, each]) => each !== undefined && each !== null && each !== false && !isEmpty(each));
  return /** @type {Value} */ (Object.fromEntries(told));
}

/** @param {unknown} value */
function isEmpty(value) {
  return typeof value === "object" && value !== null && Object.keys(value).length === 0;
}
