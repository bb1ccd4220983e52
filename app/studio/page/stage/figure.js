/** A body on the stage that shows poses of clips. */

import { Mesh, Object3D, Vector3 } from "three";
import { Retargeting, rigFromThree, sampled } from "understudy-client";

import { Glow } from "./glow.js";
import { showOnVrm } from "./vrm_face.js";

/** @import { Clip, Pose, Vector } from "understudy-client" */
/** @import { Body } from "./bodies.js" */

/**
 * Who stands on the stage: whose body, which motion, and where (metres, Y up; `turn_rad` about Y from facing +Z).
 *
 * @typedef {object} Role
 * @property {string} name
 * @property {string} character
 * @property {Clip} motion
 * @property {Vector} place_m
 * @property {number} turn_rad
 * @property {File | null} avatar in place of the character's body
 */

const LONGEST_STEP_S = 0.1;

/** Make it while the body rests. */
export class Figure {
  #vrm;
  #retargeting;
  #shown_s = 0;

  /**
   * Throws a RangeError where the body has no bones that are known.
   *
   * @param {Body} body
   * @param {Clip["joints"]} joints those of the clips
   */
  constructor({ root, vrm }, joints) {
    this.root = root;
    /** Which part of the body is pointed out. */
    this.glow = new Glow(vrm ? new Object3D() : root);
    this.#vrm = vrm;
    const bones = vrm ? { bones: bonesOf(vrm) } : {};
    this.#retargeting = new Retargeting(rigFromThree(root), joints, bones);
    root.traverse((object) => {
      object.castShadow = object instanceof Mesh;
      object.frustumCulled = false;
    });
  }

  /**
   * Shows the pose `time_s` after the clip's first frame.
   *
   * @param {Clip} clip
   * @param {number} time_s
   */
  show(clip, time_s) {
    this.pose(sampled(clip, time_s), time_s);
  }

  /**
   * Shows a pose, which is that of a time: hair and cloth swing from one to the next.
   *
   * @param {Pose} pose
   * @param {number} time_s
   */
  pose(pose, time_s) {
    this.#retargeting.show(pose);
    if (this.#vrm) {
      const step_s = Math.min(LONGEST_STEP_S, Math.abs(time_s - this.#shown_s));
      showOnVrm(this.#vrm, pose, step_s);
    }
    this.#shown_s = time_s;
  }

  /**
   * Where a joint of ours is on the stage, metres; null where the body has none of that name.
   *
   * @param {string} joint
   */
  place(joint) {
    const bone = this.#vrm?.humanoid.getRawBoneNode(/** @type {any} */ (joint)) ?? this.root.getObjectByName(joint);
    return bone?.getWorldPosition(new Vector3()) ?? null;
  }
}

/**
 * The names of a VRM's bones by our joints', which are VRM's.
 *
 * @param {import("@pixiv/three-vrm").VRM} vrm
 */
function bonesOf({ humanoid }) {
  return Object.fromEntries(Object.entries(humanoid.rawHumanBones).map(([joint, { node }]) => [joint, node.name]));
}
