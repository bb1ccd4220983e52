/**
 * From where a shot is taken, of people on their marks: metres, the audience towards +Z. Whoever is shown is seen from
 * before him and past everybody else (stage/framing.js), from the audience's side where both sides will do.
 */

import { distanceFor, framed, isClear, roundFrom } from "../stage/framing.js";

/** @import { Picture, Shot, Spot, Subject, View } from "../stage/framing.js" */

const MARGIN_M = 1.4;
const FEET_TO_HEAD = 1.16;
const ROUND_DEG = Object.freeze([0, 30, -30, 60, -60, 90, -90, 120, -120, 150, -150, 180]);
/** A little past the profile, in which two who face each other are seen. */
const LARGEST_ROUND = 1.65;

/**
 * The view of a shot of somebody, past the others; the first of them is whom he speaks to.
 *
 * @param {Shot} shot
 * @param {Subject} subject
 * @param {readonly Spot[]} others
 * @param {Picture} picture
 * @returns {View}
 */
export function viewOf(shot, subject, others, picture) {
  return shot === "wide" ? ofAll(subject, others, picture) : framed(shot, subject, others, picture);
}

/**
 * All of them, from the audience, or so far round as the face of whoever speaks is seen.
 *
 * @param {Subject} subject
 * @param {readonly Spot[]} others
 * @param {Picture} picture
 * @returns {View}
 */
function ofAll(subject, others, { aspect, eyes_m }) {
  const all = [subject, ...others];
  const reach_m = Math.max(...all.map(({ x, z }) => Math.hypot(x, z)));
  const away_m = distanceFor(2 * reach_m + MARGIN_M, FEET_TO_HEAD * eyes_m, aspect) + reach_m;
  const views = ROUND_DEG.map((deg) => {
    const round = (deg * Math.PI) / 180;
    return /** @type {View} */ ({ from_m: [away_m * Math.sin(round), eyes_m + 0.1, away_m * Math.cos(round)], at_m: [0, eyes_m * 0.58, 0] });
  });
  const faced = views.filter((view) => roundFrom(view, subject) < LARGEST_ROUND);
  const [straight] = views;
  return faced.find((view) => isClear(view, subject, others)) ?? faced[0] ?? /** @type {View} */ (straight);
}
