/** Where everybody stands in a scene, and whom they face: metres, Y up, the audience towards +Z; angles about Y from +Z. */

/** @typedef {Readonly<{ x: number, z: number }>} Mark */
/** @typedef {Readonly<{ speaker: string, listeners: readonly string[] }>} Turn who speaks, and to whom */

const NEAREST_M = 0.65;
const ELBOW_ROOM_M = 0.9;
const STRAIGHT_ON = 0;

/**
 * Marks on a circle that is open to the audience, the first on its left.
 *
 * @param {readonly string[]} names
 * @returns {Map<string, Mark>}
 */
export function marksOf(names) {
  const count = names.length;
  const radius_m = count < 2 ? 0 : Math.max(NEAREST_M, ELBOW_ROOM_M / (2 * Math.sin(Math.PI / count)));
  return new Map(
    names.map((name, place) => {
      const angle = -(Math.PI * (1 + 2 * place)) / count;
      return [name, { x: radius_m * Math.sin(angle), z: radius_m * Math.cos(angle) }];
    }),
  );
}

/**
 * Which way somebody's body faces, and which way he looks. Whoever speaks looks at the first of those he speaks to, who is
 * whoever spoke before him in most scripts, and his body is between that and the middle of them all; everybody else faces
 * the speaker. A gaze straight ahead, which is the usual one in a batch's motions, is to be at whom he looks.
 *
 * @param {string} name
 * @param {Turn} turn
 * @param {ReadonlyMap<string, Mark>} marks
 * @returns {Readonly<{ body_rad: number, gaze_rad: number }>}
 */
export function facing(name, { speaker, listeners }, marks) {
  const own = marks.get(name);
  const heard = listeners.length > 0 ? listeners : [...marks.keys()];
  const seen = (name === speaker ? heard : [speaker]).filter((each) => each !== name).flatMap((each) => marks.get(each) ?? []);
  const [first] = seen;
  if (!own || !first) {
    return { body_rad: STRAIGHT_ON, gaze_rad: STRAIGHT_ON };
  }
  const middle_rad = middleOf(seen.map((mark) => wayTo(own, mark)));
  const gaze_rad = listeners.length > 0 ? middleOf([wayTo(own, first)]) : middle_rad;
  return { body_rad: turned(middle_rad, gaze_rad, 0.5), gaze_rad };
}

/**
 * @param {Mark} from
 * @param {Mark} to
 * @returns {readonly [number, number]}
 */
function wayTo(from, to) {
  const [dx, dz] = [to.x - from.x, to.z - from.z];
  const length = Math.hypot(dx, dz) || 1;
  return [dx / length, dz / length];
}

/** @param {readonly (readonly [number, number])[]} ways */
function middleOf(ways) {
  const [dx, dz] = ways.reduce(([x, z], [wx, wz]) => [x + wx, z + wz], [0, 0]);
  return Math.atan2(dx, dz);
}

/**
 * The way from one angle to another, the shorter way round, after `share` of it.
 *
 * @param {number} from
 * @param {number} to
 * @param {number} share
 */
export function turned(from, to, share) {
  const way = Math.atan2(Math.sin(to - from), Math.cos(to - from));
  const eased = share * share * (3 - 2 * share);
  return from + way * eased;
}
