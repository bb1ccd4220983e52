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
 * Which way somebody faces: the speaker the middle of those he speaks to, everybody else the speaker. So a gaze straight
 * ahead, which is how listeners of a batch look at who speaks, is at him.
 *
 * @param {string} name
 * @param {Turn} turn
 * @param {ReadonlyMap<string, Mark>} marks
 * @returns {number}
 */
export function facing(name, { speaker, listeners }, marks) {
  const own = marks.get(name);
  const heard = listeners.length > 0 ? listeners : [...marks.keys()];
  const seen = (name === speaker ? heard : [speaker]).filter((each) => each !== name).flatMap((each) => marks.get(each) ?? []);
  if (!own || seen.length === 0) {
    return STRAIGHT_ON;
  }
  const ways = seen.map(({ x, z }) => {
    const [dx, dz] = [x - own.x, z - own.z];
    const length = Math.hypot(dx, dz) || 1;
    return [dx / length, dz / length];
  });
  const [dx, dz] = [0, 1].map((axis) => ways.reduce((sum, way) => sum + (way[axis] ?? 0), 0));
  return Math.atan2(dx ?? 0, dz ?? 1);
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
