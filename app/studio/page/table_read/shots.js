/** From where a shot is taken, of people on their marks: metres, the audience towards +Z. The camera stays on its side. */

/** @import { Shot } from "./cuts.js" */
/** @import { Mark } from "./marks.js" */
/** @import { View } from "../stage/cameras.js" */

const CLOSE_M = 1.5;
const BEHIND_M = 0.9;
const BESIDE_M = 0.62;
const WIDE_M = 2.2;

/**
 * The view of a shot of whoever stands on `subject`, past whoever stands on `beside`.
 *
 * @param {Shot} shot
 * @param {Mark} subject
 * @param {Mark | null} beside
 * @param {{ eyes_m: number, reach_m: number }} scene the height of the eyes, and how far from the middle marks are
 * @returns {View}
 */
export function viewOf(shot, subject, beside, { eyes_m, reach_m }) {
  if (shot === "wide") {
    return { from_m: [0, eyes_m + 0.1, reach_m + WIDE_M + 2 * reach_m], at_m: [0, eyes_m * 0.62, 0] };
  }
  if (shot === "over_shoulder" && beside) {
    return overShoulder(subject, beside, eyes_m);
  }
  const [ux, uz] = towards(subject, beside ?? { x: subject.x, z: subject.z + 1 });
  const [cx, cz] = unit(ux, uz + 1.2);
  const from_m = /** @type {const} */ ([subject.x + cx * CLOSE_M, eyes_m - 0.05, subject.z + cz * CLOSE_M]);
  return { from_m, at_m: [subject.x, eyes_m * 0.9, subject.z] };
}

/**
 * @param {Mark} subject
 * @param {Mark} beside
 * @param {number} eyes_m
 * @returns {View}
 */
function overShoulder(subject, beside, eyes_m) {
  const [ux, uz] = towards(subject, beside);
  const side = ux >= 0 ? 1 : -1;
  const [x, z] = [beside.x + ux * BEHIND_M - side * uz * BESIDE_M, beside.z + uz * BEHIND_M + side * ux * BESIDE_M];
  return { from_m: [x, eyes_m + 0.12, z], at_m: [subject.x, eyes_m * 0.93, subject.z] };
}

/**
 * @param {Mark} from
 * @param {Mark} to
 */
function towards(from, to) {
  return unit(to.x - from.x, to.z - from.z);
}

/**
 * @param {number} x
 * @param {number} z
 * @returns {[number, number]}
 */
function unit(x, z) {
  const length = Math.hypot(x, z) || 1;
  return [x / length, z / length];
}
