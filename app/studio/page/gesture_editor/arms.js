/** Whose arms a gesture is for, and poses of both. */

import { withArm } from "./frames.js";

/** @import { AvatarPose, GestureArm, GestureValues } from "understudy-client" */

/** Either hand may make the gesture. */
export const EITHER = "";

/**
 * The gesture for other arms; what it says of the other arm goes where there is none.
 *
 * @param {GestureValues} gesture
 * @param {string} arms
 * @returns {GestureValues}
 */
export function withArms(gesture, arms) {
  const chosen = arms === EITHER ? null : /** @type {"left" | "right" | "both"} */ (arms);
  const frames = chosen === "both" ? gesture.frames : gesture.frames.map((frame) => ({ ...frame, other: null }));
  return { ...gesture, arms: chosen, frames };
}

/**
 * The gesture with the pose in a frame: the leading arm's is the right's, unless the gesture is for the left hand or the
 * right hangs as in the T-pose; the other arm's is the left's where it is another one.
 *
 * @param {GestureValues} gesture
 * @param {number} index
 * @param {AvatarPose["arms"]} arms
 * @returns {GestureValues}
 */
export function withPose(gesture, index, arms) {
  const right = /** @type {NonNullable<GestureArm["joints"]>} */ (arms["right"] ?? {});
  const left = /** @type {NonNullable<GestureArm["joints"]>} */ (arms["left"] ?? {});
  const isLeft = gesture.arms === "left" || Object.keys(right).length === 0;
  const posed = withArm(gesture, index, "leading", { joints: isLeft ? left : right });
  const differs = JSON.stringify(left) !== JSON.stringify(right);
  return gesture.arms === "both" && differs ? withArm(posed, index, "other", { joints: left }) : posed;
}
