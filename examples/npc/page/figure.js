/** An NPC on the stage: its body, and what plays clips on it. */

import { Mesh, Vector3 } from "three";
import { GLTFLoader } from "three/addons/loaders/GLTFLoader.js";
import { clipFromJson, Performer, Retargeting, rigFromThree } from "understudy-client";

import { fetched } from "./fetching.js";

/** @import { Object3D, Scene } from "three" */
/** @import { Npc } from "../server/dialogue.js" */

/** A body that stands somewhere and performs. */
export class Figure {
  /** @type {Object3D} */
  #body;
  /** @type {Performer} */
  performer;

  /**
   * @param {Object3D} body
   * @param {Performer} performer
   */
  constructor(body, performer) {
    this.#body = body;
    this.performer = performer;
  }

  /**
   * Where a bone is on the stage, metres.
   *
   * @param {string} bone
   */
  place(bone) {
    const place = new Vector3();
    return this.#body.getObjectByName(bone)?.getWorldPosition(place).toArray() ?? [];
  }

  /**
   * How far a bone's forward direction points up, radians.
   *
   * @param {string} bone
   */
  pitch(bone) {
    const direction = new Vector3();
    return Math.asin(this.#body.getObjectByName(bone)?.getWorldDirection(direction).y ?? 0);
  }

  /**
   * The weight of a blend shape.
   *
   * @param {string} shape
   */
  weight(shape) {
    let weight = 0;
    this.#body.traverse((object) => {
      const index = object instanceof Mesh ? object.morphTargetDictionary?.[shape] : undefined;
      if (object instanceof Mesh && index !== undefined) {
        weight = object.morphTargetInfluences?.[index] ?? 0;
      }
    });
    return weight;
  }
}

/**
 * The figure of an NPC, which is on the stage then and stands idle.
 *
 * @param {"speaker" | "listener"} role
 * @param {Npc} npc
 * @param {Scene} scene
 */
export async function loadedFigure(role, npc, scene) {
  const [{ scene: body }, idle] = await Promise.all([
    new GLTFLoader().loadAsync(`/bodies/${role}.glb`),
    fetched(`/idles/${role}.json`).then(clipFromJson),
  ]);
  const performer = new Performer(new Retargeting(rigFromThree(body), idle.joints, { eyeLook: true }), idle);
  body.traverse((object) => {
    object.castShadow = true;
    object.frustumCulled = false;
  });
  body.position.set(...npc.place);
  body.rotation.y = (npc.faces_deg * Math.PI) / 180;
  scene.add(body);
  return new Figure(body, performer);
}
