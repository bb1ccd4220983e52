/**
 * What can be chosen, given what was chosen already (Gesture Engine §4.3): nothing else is offered, so no gesture is
 * composed that makes no sense. The tables are the service's, which checks by the same.
 */

/** @import { GestureArm, GestureFrame, GestureLanguage } from "understudy-client" */

/** @typedef {NonNullable<GestureArm["wrist"]>} Wrist */
/** @typedef {NonNullable<GestureArm["place"]>} Place */

const LEAST_STEP = 0.01;
const IN_LINE = 0;

/**
 * The place of a sum of directions among `orientations`; the first is that of the forearm.
 *
 * @param {GestureLanguage} language
 * @param {readonly string[]} directions
 */
export function orientationOf({ orientations }, directions = []) {
  const wanted = [...directions].sort().join();
  const found = orientations.findIndex((each) => [...each.directions].sort().join() === wanted);
  return found < 0 ? IN_LINE : found;
}

/**
 * The places of the orientations that fingers or palm can have while the other part has `directions`.
 *
 * @param {GestureLanguage} language
 * @param {readonly string[]} [directions]
 * @returns {ReadonlySet<number>}
 */
export function partnersOf(language, directions = []) {
  return new Set(language.orientations[orientationOf(language, directions)]?.partners ?? []);
}

/**
 * The thumbs that a form leaves free.
 *
 * @param {GestureLanguage} language
 * @param {string} form
 */
export function thumbsOf({ forms }, form) {
  return forms.find(({ name }) => name === form)?.thumbs ?? [];
}

/**
 * Whether the wrist reaches a sector.
 *
 * @param {GestureLanguage} language
 * @param {Readonly<{ x: string, y: string, z: string }>} place
 */
export function isWithinReach({ out_of_reach }, { x, y, z }) {
  return !out_of_reach.some(([ox, oy, oz]) => ox === x && oy === y && oz === z);
}

/**
 * The types that a frame can have between its neighbours: in order, and an instant once.
 *
 * @param {GestureLanguage} language
 * @param {readonly GestureFrame[]} frames
 * @param {number} index of the frame
 */
export function typesAt({ frame_types }, frames, index) {
  const rank = (/** @type {string | undefined} */ type) => frame_types.findIndex(({ name }) => name === type);
  const before = rank(frames[index - 1]?.type);
  const after = index + 1 < frames.length ? rank(frames[index + 1]?.type) : frame_types.length;
  return frame_types
    .filter(({ once }, own) => (once ? before < own && own < after : before <= own && own <= after))
    .map(({ name }) => name);
}

/**
 * The times that a frame can have: between its neighbours, and from 0 to 1.
 *
 * @param {readonly GestureFrame[]} frames
 * @param {number} index of the frame
 * @returns {readonly [least: number, most: number]}
 */
export function timesAt(frames, index) {
  const before = frames[index - 1];
  const after = frames[index + 1];
  return [before ? rounded(before.time + LEAST_STEP) : 0, after ? rounded(after.time - LEAST_STEP) : 1];
}

/**
 * Where another frame fits behind this one: its time and the types it can have; null where there is no room.
 *
 * @param {GestureLanguage} language
 * @param {readonly GestureFrame[]} frames
 * @param {number} index of the frame
 */
export function roomBehind(language, frames, index) {
  const time = frames[index]?.time ?? 0;
  const end = frames[index + 1]?.time ?? 1;
  const middle = rounded((time + end) / 2);
  const between = [...frames.slice(0, index + 1), { ...frames[index], time: middle, type: "stroke" }, ...frames.slice(index + 1)];
  const types = typesAt(language, /** @type {GestureFrame[]} */ (between), index + 1);
  return end - time < 2 * LEAST_STEP || types.length === 0 ? null : { time: middle, types };
}

/** @param {number} time */
function rounded(time) {
  return Math.round(time * 1000) / 1000;
}
