/** Where the wrists of a clip are, from its joints alone: metres, Y up, in the space of who performs. */

/** @import { Clip, Quaternion, Vector } from "understudy-client" */

import { sampled } from "understudy-client";

/** @typedef {"left" | "right"} Side */

/**
 * The places of a wrist, `rate_hz` times a second from the first frame to the last.
 *
 * @param {Clip} clip
 * @param {Side} side
 * @param {number} rate_hz
 * @returns {Vector[]}
 */
export function wristPath(clip, side, rate_hz) {
  const chain = jointsAbove(clip, `${side}Hand`);
  const own = { ...clip, turns: new Map(chain.map(({ name }) => [name, turnsOf(clip, name)])) };
  const bare = { ...own, shapes: new Map(), visemes: new Map() };
  const count = Math.floor(clip.durationS * rate_hz) + 1;
  return Array.from({ length: count }, (_, index) => placeOf(chain, sampled(bare, index / rate_hz)));
}

/**
 * @param {Clip} clip
 * @param {string} name
 */
function turnsOf(clip, name) {
  return clip.turns.get(name) ?? { timesS: Float32Array.of(0), values: Float32Array.of(0, 0, 0, 1), size: 4 };
}

/**
 * A joint and those that carry it, from the root.
 *
 * @param {Clip} clip
 * @param {string} name
 */
function jointsAbove(clip, name) {
  const byName = new Map(clip.joints.map((joint) => [joint.name, joint]));
  const chain = [];
  for (let joint = byName.get(name); joint; joint = joint.parent === null ? undefined : byName.get(joint.parent)) {
    chain.unshift(joint);
  }
  return chain;
}

/**
 * @param {Clip["joints"]} chain
 * @param {ReturnType<typeof sampled>} pose
 * @returns {Vector}
 */
function placeOf(chain, pose) {
  /** @type {Vector} */
  let place = pose.hipsM;
  let turn = pose.turns.get(chain[0]?.name ?? "") ?? NO_TURN;
  for (const { name, offsetM } of chain.slice(1)) {
    const [x, y, z] = turned(turn, offsetM);
    place = [place[0] + x, place[1] + y, place[2] + z];
    turn = after(turn, pose.turns.get(name) ?? NO_TURN);
  }
  return place;
}

/** @type {Quaternion} */
const NO_TURN = [0, 0, 0, 1];

/**
 * @param {Quaternion} first
 * @param {Quaternion} second
 * @returns {Quaternion}
 */
function after([ax, ay, az, aw], [bx, by, bz, bw]) {
  return [
    aw * bx + ax * bw + ay * bz - az * by,
    aw * by - ax * bz + ay * bw + az * bx,
    aw * bz + ax * by - ay * bx + az * bw,
    aw * bw - ax * bx - ay * by - az * bz,
  ];
}

/**
 * @param {Quaternion} turn
 * @param {Vector} vector
 * @returns {Vector}
 */
function turned(turn, [x, y, z]) {
  const [rx, ry, rz] = after(after(turn, [x, y, z, 0]), [-turn[0], -turn[1], -turn[2], turn[3]]);
  return [rx, ry, rz];
}
