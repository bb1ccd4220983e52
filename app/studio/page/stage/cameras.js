/** From where the stage is looked at: the shots of a line, whose speaker stands at the origin and faces +Z. */

import { framed } from "./framing.js";

/** @import { Vector } from "understudy-client" */
/** @import { Shot, View } from "./framing.js" */

/** @typedef {import("./framing.js").Shot} Shot */
/** @typedef {import("./framing.js").View} View */

/** Shots with the names that people read. @type {readonly (readonly [Shot, string])[]} */
export const SHOTS = Object.freeze([
  ["wide", "Wide"],
  ["medium", "Medium"],
  ["close", "Close-up"],
  ["two_shot", "Two-shot"],
  ["over_shoulder", "Shoulder"],
]);

/** Where a listener stands if the line does not say: metres. @type {Vector} */
export const OPPOSITE_M = Object.freeze([0, 0, 1.7]);

const USUAL_ASPECT = 1.6;

/**
 * The view of a shot on the speaker, whose eyes are at the height `eyes_m`. Somebody's head at `listener_m` is looked past;
 * with nobody there it is null.
 *
 * @param {Shot} shot
 * @param {number} eyes_m
 * @param {Vector | null} listener_m
 * @param {Readonly<{ aspect?: number, extra_m?: number }>} [picture] its width to its height; how much wider than one body
 *   what is shown is, to the speaker's left
 * @returns {View}
 */
export function viewOf(shot, eyes_m, listener_m, { aspect = USUAL_ASPECT, extra_m = 0 } = {}) {
  const heard = listener_m ?? (shot === "over_shoulder" ? OPPOSITE_M : null);
  const others = heard ? [{ x: heard[0], z: heard[2] }] : [];
  return framed(shot, { x: 0, z: 0, facing_rad: 0 }, others, { aspect, eyes_m, extra_m });
}
