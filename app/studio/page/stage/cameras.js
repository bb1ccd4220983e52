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

/** Where a listener stands if the line does not say: metres. @type {Vector} */
export const OPPOSITE_M = Object.freeze([0, 0, 1.7]);

const BEHIND_M = 0.75;
const BESIDE_M = 0.38;
const ABOVE_M = 0.12;

/**
 * From where a shot is taken of somebody alone and past whoever listens (metres beside the speaker and before him), and
 * where it is aimed, as a share of the height of the eyes.
 */
const FRAMES = Object.freeze({
  wide: { alone_m: [0.9, 4.4], past_m: [3.4, 3.1], aim: 0.56 },
  medium: { alone_m: [0.35, 2.7], past_m: [1.9, 1.9], aim: 0.76 },
  close: { alone_m: [0.12, 1.25], past_m: [0.75, 0.95], aim: 0.97 },
});

/**
 * The view of a shot on whoever stands at the origin and faces +Z, whose eyes are at the height `eyes_m`. Somebody's
 * head at `listener_m` is looked past; with nobody there it is null.
 *
 * @param {Shot} shot
 * @param {number} eyes_m
 * @param {Vector | null} listener_m
 * @returns {View}
 */
export function viewOf(shot, eyes_m, listener_m) {
  if (shot === "over_shoulder") {
    return { from_m: behind(listener_m ?? [OPPOSITE_M[0], eyes_m, OPPOSITE_M[2]]), at_m: [0, eyes_m * 0.92, 0] };
  }
  const { alone_m, past_m, aim } = FRAMES[shot];
  const [x = 0, z = 0] = listener_m ? past_m : alone_m;
  const between_m = shot === "wide" && listener_m ? listener_m[2] / 2 : 0;
  return { from_m: [x, eyes_m, z], at_m: [0, eyes_m * aim, between_m] };
}

/**
 * The view from so much further along X, of what is as much further along.
 *
 * @param {View} view
 * @param {number} aside_m
 * @returns {View}
 */
export function movedAside({ from_m, at_m }, aside_m) {
  return { from_m: [from_m[0] + aside_m, from_m[1], from_m[2]], at_m: [at_m[0] + aside_m, at_m[1], at_m[2]] };
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
