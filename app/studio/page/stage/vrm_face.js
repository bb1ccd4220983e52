/** What a VRM has beside bones: expressions for lips, lids, moods and looks, and hair and cloth that swing. */

/** @import { VRM } from "@pixiv/three-vrm" */
/** @import { Pose } from "understudy-client" */

/** VRM's mouths, and the visemes that they stand for. */
const MOUTHS = Object.freeze([["aa", "aa"], ["ih", "I"], ["ou", "U"], ["ee", "E"], ["oh", "O"]]);

/**
 * VRM's expressions as mixtures of ARKit's shapes: each shape with its share. The moods are those of our `.vrma` files
 * (docs/motion-formats.md).
 *
 * @type {readonly (readonly [string, readonly (readonly [string, number])[]])[]}
 */
const MIXTURES = Object.freeze([
  ["blinkLeft", [["eyeBlinkLeft", 1]]],
  ["blinkRight", [["eyeBlinkRight", 1]]],
  ["happy", [["mouthSmileLeft", 0.5], ["mouthSmileRight", 0.5]]],
  ["angry", [["browDownLeft", 0.35], ["browDownRight", 0.35], ["noseSneerLeft", 0.15], ["noseSneerRight", 0.15]]],
  ["sad", [["browInnerUp", 0.4], ["mouthFrownLeft", 0.3], ["mouthFrownRight", 0.3]]],
  ["surprised", [["browOuterUpLeft", 0.2], ["browOuterUpRight", 0.2], ["eyeWideLeft", 0.3], ["eyeWideRight", 0.3]]],
]);

/** With looks, where no bones turn the eyes. @type {typeof MIXTURES} */
const WITH_LOOKS = Object.freeze([
  ...MIXTURES,
  ["lookLeft", [["eyeLookOutLeft", 0.5], ["eyeLookInRight", 0.5]]],
  ["lookRight", [["eyeLookInLeft", 0.5], ["eyeLookOutRight", 0.5]]],
  ["lookUp", [["eyeLookUpLeft", 0.5], ["eyeLookUpRight", 0.5]]],
  ["lookDown", [["eyeLookDownLeft", 0.5], ["eyeLookDownRight", 0.5]]],
]);

/**
 * Shows the face, and lets what hangs on bones follow them: what swings swings for `step_s`.
 *
 * @param {VRM} vrm
 * @param {Pose} pose
 * @param {number} step_s
 */
export function showOnVrm({ expressionManager, humanoid, nodeConstraintManager, springBoneManager }, pose, step_s) {
  if (expressionManager) {
    express(expressionManager, pose, humanoid.rawHumanBones.leftEye ? MIXTURES : WITH_LOOKS);
  }
  nodeConstraintManager?.update();
  springBoneManager?.update(step_s);
}

/**
 * @param {NonNullable<VRM["expressionManager"]>} manager
 * @param {Pose} pose
 * @param {typeof MIXTURES} mixtures
 */
function express(manager, pose, mixtures) {
  for (const [mouth = "", viseme = ""] of MOUTHS) {
    manager.setValue(mouth, pose.visemes.get(viseme) ?? 0);
  }
  for (const [expression, mixture] of mixtures) {
    manager.setValue(expression, mixed(pose.shapes, mixture));
  }
  manager.update();
}

/**
 * @param {Pose["shapes"]} shapes
 * @param {readonly (readonly [string, number])[]} mixture
 */
function mixed(shapes, mixture) {
  return Math.min(1, mixture.reduce((sum, [shape, share]) => sum + share * (shapes.get(shape) ?? 0), 0));
}
