/** What a VRM has beside bones: expressions for lips and lids, and hair and cloth that swing. */

/** @import { VRM } from "@pixiv/three-vrm" */
/** @import { Pose } from "understudy-client" */

/** VRM's mouths, and the visemes that each of them stands for. */
const MOUTHS = Object.freeze({ aa: ["aa"], ih: ["I"], ou: ["U"], ee: ["E"], oh: ["O"] });
const LIDS = Object.freeze({ blinkLeft: "eyeBlinkLeft", blinkRight: "eyeBlinkRight" });

/**
 * Shows lips and lids, and lets what swings swing for `step_s`.
 *
 * @param {VRM} vrm
 * @param {Pose} pose
 * @param {number} step_s
 */
export function showOnVrm({ expressionManager, springBoneManager }, pose, step_s) {
  if (expressionManager) {
    for (const [mouth, visemes] of Object.entries(MOUTHS)) {
      expressionManager.setValue(mouth, Math.max(...visemes.map((name) => pose.visemes.get(name) ?? 0)));
    }
    for (const [lid, shape] of Object.entries(LIDS)) {
      expressionManager.setValue(lid, pose.shapes.get(shape) ?? 0);
    }
    expressionManager.update();
  }
  springBoneManager?.update(step_s);
}
