/** Shows which part of a body makes a movement: what hangs on the joints that move glows. */

import { SkinnedMesh } from "three";

/** @import { Behavior } from "understudy-client" */
/** @import { Material, Object3D } from "three" */

const COLOUR = "vec3(0.10, 0.28, 0.75)";

/** Joints by the beginnings of their names, for what is not done by an arm. @type {Readonly<Record<string, readonly string[]>>} */
const PARTS = Object.freeze({
  head: ["head", "neck", "leftEye", "rightEye"],
  gaze: ["head", "leftEye", "rightEye"],
  eyes: ["head", "leftEye", "rightEye"],
  face: ["head", "leftEye", "rightEye"],
  posture: ["hips", "spine", "chest", "upperChest"],
});
const ARM = /^(left|right)(Shoulder|UpperArm|LowerArm|Hand|Thumb|Index|Middle|Ring|Little)/;

/**
 * Whether a joint takes part in a movement.
 *
 * @param {string} joint
 * @param {Pick<Behavior, "kind" | "hand">} behavior
 */
export function takesPart(joint, { kind, hand }) {
  if (kind === "gesture") {
    const side = ARM.exec(joint)?.[1];
    return side !== undefined && (hand === "both" || hand === side);
  }
  return PARTS[kind]?.includes(joint) ?? false;
}

/** The glow of one body; a body without skin never glows. */
export class Glow {
  /** @type {readonly string[]} */
  #joints = [];
  #shares = { value: new Float32Array() };

  /** @param {Object3D} root */
  constructor(root) {
    root.traverse((object) => {
      if (object instanceof SkinnedMesh && !Array.isArray(object.material)) {
        this.#joints = object.skeleton.bones.map(({ name }) => name);
        this.#shares.value = new Float32Array(this.#joints.length);
        object.material = glowing(object.material.clone(), this.#shares, this.#joints.length);
      }
    });
  }

  /** @param {Pick<Behavior, "kind" | "hand"> | null} behavior null for none */
  show(behavior) {
    const shares = this.#joints.map((joint) => Number(behavior !== null && takesPart(joint, behavior)));
    this.#shares.value.set(shares);
  }
}

/**
 * A material that glows as far as its vertices hang on joints that glow.
 *
 * @param {Material} material
 * @param {{ value: Float32Array }} shares
 * @param {number} count
 */
function glowing(material, shares, count) {
  material.onBeforeCompile = (shader) => {
    shader.uniforms["glow"] = shares;
    const told = [0, 1, 2, 3].map((place) => `skinWeight[${String(place)}] * glow[int(skinIndex[${String(place)}])]`).join(" + ");
    shader.vertexShader = shader.vertexShader
      .replace("#include <common>", `#include <common>\nuniform float glow[${String(count)}];\nvarying float vGlow;`)
      .replace("#include <skinning_vertex>", `#include <skinning_vertex>\nvGlow = ${told};`);
    shader.fragmentShader = shader.fragmentShader
      .replace("#include <common>", "#include <common>\nvarying float vGlow;")
      .replace("#include <emissivemap_fragment>", `#include <emissivemap_fragment>\ntotalEmissiveRadiance += vGlow * ${COLOUR};`);
  };
  material.customProgramCacheKey = () => `glow ${String(count)}`;
  return material;
}
