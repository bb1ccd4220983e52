/** Looking elsewhere than straight ahead: the head is turned further than a motion has it, and the eyes with it. */

import { Quaternion, Vector3 } from "three";

/** @import { Pose, Quaternion as Turn } from "understudy-client" */

/** How much of it each joint turns. */
const SHARES = Object.freeze({ neck: 0.45, head: 0.55 });
const UP = Object.freeze(new Vector3(0, 1, 0));

/**
 * A pose with the head turned so far to its left.
 *
 * @param {Pose} pose
 * @param {number} left_rad
 * @returns {Pose}
 */
export function lookingAside(pose, left_rad) {
  if (left_rad === 0) {
    return pose;
  }
  const turns = new Map(pose.turns);
  for (const [joint, share] of Object.entries(SHARES)) {
    const own = new Quaternion(...(pose.turns.get(joint) ?? [0, 0, 0, 1]));
    const turned = own.premultiply(new Quaternion().setFromAxisAngle(UP, share * left_rad));
    turns.set(joint, /** @type {Turn} */ (turned.toArray()));
  }
  return { ...pose, turns };
}
