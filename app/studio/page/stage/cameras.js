/** From where the stage is looked at. */

/** @import { Vector } from "understudy-client" */

/** @typedef {"wide" | "medium" | "close" | "over_shoulder"} Shot */
/** @typedef {Readonly<{ from_m: Vector, at_m: Vector }>} View */

/** Shots with the names that people read. @type {readonly (readonly [Shot, string])[]} */
export const SHOTS = Object.freeze([
  ["wide", "Wide"],
  ["medium", "Medium"],
  ["close", "Close"],
  ["over_shoulder", "Over the listener's shoulder"],
]);

const BEHIND_M = 0.75;
const BESIDE_M = 0.38;
const ABOVE_M = 0.12;

/**
 * The view of a shot on whoever stands at the origin and faces +Z, whose eyes are at the height `eyes_m`, and whose
 * listener's head is at `listener_m`.
 *
 * @param {Shot} shot
 * @param {number} eyes_m
 * @param {Vector} listener_m
 * @returns {View}
 */
export function viewOf(shot, eyes_m, listener_m) {
  switch (shot) {
    case "wide":
      return { from_m: [0.9, eyes_m, 4.4], at_m: [0, eyes_m * 0.56, 0] };
    case "medium":
      return { from_m: [0.35, eyes_m, 2.7], at_m: [0, eyes_m * 0.76, 0] };
    case "close":
      return { from_m: [0.12, eyes_m, 1.25], at_m: [0, eyes_m * 0.97, 0] };
    case "over_shoulder":
      return { from_m: behind(listener_m), at_m: [0, eyes_m * 0.92, 0] };
  }
}

/**
 * A place behind a head that looks at the origin, and to its right.
 *
 * @param {Vector} head_m
 * @returns {Vector}
 */
function behind([x, y, z]) {
  const away_m = Math.hypot(x, z) || 1;
  const [ux, uz] = [x / away_m, z / away_m];
  return [x + ux * BEHIND_M + uz * BESIDE_M, y + ABOVE_M, z + uz * BEHIND_M - ux * BESIDE_M];
}
