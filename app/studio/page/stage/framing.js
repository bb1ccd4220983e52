/**
 * From where a shot is taken, by rules of the craft: face and hands are in the picture, whoever is shown is seen from
 * before him, and nobody stands in the line of sight. Metres, Y up; angles about Y from +Z.
 */

/** @import { Vector } from "understudy-client" */

/** @typedef {"wide" | "medium" | "close" | "two_shot" | "over_shoulder"} Shot */
/** @typedef {Readonly<{ from_m: Vector, at_m: Vector }>} View */
/** @typedef {Readonly<{ x: number, z: number }>} Spot */
/** Somebody who is shown, and which way he faces. @typedef {Spot & Readonly<{ facing_rad: number }>} Subject */

/**
 * The picture: how wide it is to its height, the height of eyes, how much wider the subject is than one body.
 *
 * @typedef {Readonly<{ aspect: number, eyes_m: number, extra_m?: number }>} Picture
 */

/** The camera's vertical field of view. */
export const FIELD_DEG = 32;

/** What of a body is in the picture, as shares of the height of its eyes, and how far hands reach to both sides. */
const FRAMES = Object.freeze({
  wide: { from: 0, to: 1.16, width_m: 1.9 },
  medium: { from: 0.44, to: 1.17, width_m: 1.6 },
  close: { from: 0.56, to: 1.15, width_m: 1.05 },
});
/** Room for names above the heads, where several are compared: another share. */
const NAMED = 0.05;
const DEPTH_M = 0.3;
const BODY_M = 0.34;
const NEAREST_M = 0.5;
const REACH_M = 0.35;
const [BEHIND_M, BESIDE_M, ABOVE_M] = [0.8, 0.7, 0.12];

/** How far round from straight before somebody the camera may go, the best first: degrees. */
const ROUND_DEG = Object.freeze([28, 38, 48, 18, 58, 68, 8, 0]);
const ALONE_DEG = 8;

/**
 * The view of a shot of somebody, past everybody else on the stage; the first of them is whom he speaks to. Of places that
 * are as good, the one nearest to `audience` (+Z unless told) is taken.
 *
 * @param {Shot} shot
 * @param {Subject} subject
 * @param {readonly Spot[]} others
 * @param {Picture} picture
 * @returns {View}
 */
export function framed(shot, subject, others, picture) {
  const [partner] = others;
  if (partner && shot === "over_shoulder") {
    return best([1, -1].map((side) => overShoulder(subject, partner, side, picture)), subject, others.slice(1));
  }
  if (partner && (shot === "two_shot" || shot === "wide")) {
    return best(besideBoth(shot, subject, partner, picture), subject, others);
  }
  return ofOne(shot === "two_shot" || shot === "over_shoulder" ? "medium" : shot, subject, others, picture);
}

/**
 * How far the camera is from what has this size.
 *
 * @param {number} width_m
 * @param {number} height_m
 * @param {number} aspect
 */
export function distanceFor(width_m, height_m, aspect) {
  const half = Math.tan((FIELD_DEG * Math.PI) / 360);
  return Math.max(height_m, width_m / aspect) / 2 / half + DEPTH_M;
}

/**
 * Whether face and hands are seen from a place, past everybody else.
 *
 * @param {View} view
 * @param {Subject} subject
 * @param {readonly Spot[]} others
 */
export function isClear({ from_m: [x, , z] }, subject, others) {
  const from = { x, z };
  return others.every((other) => far(from, other) >= NEAREST_M && seen(subject).every((point) => fromSight(from, point, other) >= BODY_M));
}

/**
 * How far round the camera is from straight before somebody, radians: his face is not seen from π/2 on.
 *
 * @param {View} view
 * @param {Subject} subject
 */
export function roundFrom({ from_m: [x, , z] }, { x: sx, z: sz, facing_rad }) {
  const round = Math.atan2(x - sx, z - sz) - facing_rad;
  return Math.abs(Math.atan2(Math.sin(round), Math.cos(round)));
}

/**
 * @param {keyof typeof FRAMES} shot
 * @param {Subject} subject
 * @param {readonly Spot[]} others
 * @param {Picture} picture
 */
function ofOne(shot, subject, others, { aspect, eyes_m, extra_m = 0 }) {
  const { from, width_m } = FRAMES[shot];
  const to = FRAMES[shot].to + (extra_m > 0 ? NAMED : 0);
  const away_m = distanceFor(width_m + extra_m, (to - from) * eyes_m, aspect);
  const height_m = ((from + to) / 2) * eyes_m;
  const views = (others.length > 0 ? ROUND_DEG : [ALONE_DEG]).flatMap((deg) => [deg, -deg]).map((deg) => {
    const round = subject.facing_rad + (deg * Math.PI) / 180;
    const at_m = /** @type {Vector} */ ([subject.x + extra_m / 2, height_m, subject.z]);
    return { from_m: /** @type {Vector} */ ([at_m[0] + away_m * Math.sin(round), eyes_m * 0.98, subject.z + away_m * Math.cos(round)]), at_m };
  });
  return best(views, subject, others);
}

/**
 * Both, from beside them: from both sides, turned so far that the face of the subject is seen.
 *
 * @param {"two_shot" | "wide"} shot
 * @param {Subject} subject
 * @param {Spot} partner
 * @param {Picture} picture
 */
function besideBoth(shot, subject, partner, { aspect, eyes_m }) {
  const { from, to } = FRAMES[shot === "wide" ? "wide" : "medium"];
  // Whoever is nearer to the camera is to be whole in the picture as well.
  const away_m = distanceFor(far(subject, partner) + 1.1, (to - from) * eyes_m, aspect) + far(subject, partner) / 3;
  const middle = { x: (subject.x + partner.x) / 2, z: (subject.z + partner.z) / 2 };
  const along = Math.atan2(partner.x - subject.x, partner.z - subject.z);
  return [65, -65, 50, -50].map((deg) => {
    const round = along + (deg * Math.PI) / 180;
    const from_m = /** @type {Vector} */ ([middle.x + away_m * Math.sin(round), eyes_m, middle.z + away_m * Math.cos(round)]);
    return { from_m, at_m: /** @type {Vector} */ ([middle.x, ((from + to) / 2) * eyes_m, middle.z]) };
  });
}

/**
 * @param {Subject} subject
 * @param {Spot} partner
 * @param {number} side
 * @param {Picture} picture
 * @returns {View}
 */
function overShoulder(subject, partner, side, { eyes_m }) {
  const apart_m = far(subject, partner) || 1;
  const [ux, uz] = [(partner.x - subject.x) / apart_m, (partner.z - subject.z) / apart_m];
  const [x, z] = [partner.x + ux * BEHIND_M + side * uz * BESIDE_M, partner.z + uz * BEHIND_M - side * ux * BESIDE_M];
  return { from_m: [x, eyes_m + ABOVE_M, z], at_m: [subject.x, eyes_m * 0.88, subject.z] };
}

/**
 * The first view that is clear and shows the face, the one nearer to the audience of two alike; else the last resort.
 *
 * @param {readonly View[]} views in pairs, left and right
 * @param {Subject} subject
 * @param {readonly Spot[]} others
 * @returns {View}
 */
function best(views, subject, others) {
  const pairs = views.map((_, index) => Math.floor(index / 2));
  const ordered = views
    .map((view, index) => ({ view, pair: pairs[index] ?? 0 }))
    .sort((one, other) => one.pair - other.pair || other.view.from_m[2] - one.view.from_m[2])
    .map(({ view }) => view);
  const good = ordered.find((view) => isClear(view, subject, others) && roundFrom(view, subject) < 1.3);
  return good ?? ordered.find((view) => roundFrom(view, subject) < 1.3) ?? /** @type {View} */ (ordered[0]);
}

/**
 * Where the face and the hands are, seen from above.
 *
 * @param {Subject} subject
 * @returns {Spot[]}
 */
function seen({ x, z, facing_rad }) {
  const [sin, cos] = [Math.sin(facing_rad), Math.cos(facing_rad)];
  const hand = (/** @type {number} */ side) => ({ x: x + REACH_M * (0.6 * sin + side * cos), z: z + REACH_M * (0.6 * cos - side * sin) });
  return [{ x, z }, hand(1), hand(-1)];
}

/**
 * @param {Spot} one
 * @param {Spot} other
 */
function far(one, other) {
  return Math.hypot(one.x - other.x, one.z - other.z);
}

/**
 * How far somebody is from the line of sight to a point.
 *
 * @param {Spot} from
 * @param {Spot} to
 * @param {Spot} other
 */
function fromSight(from, to, other) {
  const [dx, dz] = [to.x - from.x, to.z - from.z];
  const share = ((other.x - from.x) * dx + (other.z - from.z) * dz) / (dx * dx + dz * dz || 1);
  const nearest = Math.min(1, Math.max(0, share));
  return far(other, { x: from.x + nearest * dx, z: from.z + nearest * dz });
}
