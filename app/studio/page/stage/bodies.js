/** Bodies to move: each character's mannequin, as the service makes it, or a GLB or VRM file that the author dropped. */

import { VRMLoaderPlugin, VRMUtils } from "@pixiv/three-vrm";
import { Group } from "three";
import { GLTFLoader } from "three/addons/loaders/GLTFLoader.js";
import { clone } from "three/addons/utils/SkeletonUtils.js";

import { checkClaims } from "./glb_claims.js";

/** @import { VRM } from "@pixiv/three-vrm" */
/** @import { Object3D } from "three" */
/** @import { Service } from "../service/service.js" */

/** @typedef {{ root: Object3D, vrm: VRM | null }} Body */

const STANDING = '<bml xmlns="http://www.bml-initiative.org/bml/bml-1.0" id="standing"/>';

/** Of a file that is no body. */
export class NotABodyError extends Error {}

/** Loads bodies; a character's is asked for once. */
export class Bodies {
  #service;
  /** @type {Map<string, Promise<Object3D>>} */
  #mannequins = new Map();

  /** @param {Service} service */
  constructor(service) {
    this.#service = service;
  }

  /**
   * A body of a character, for one figure alone.
   *
   * @param {string} character
   * @returns {Promise<Body>}
   */
  async mannequin(character) {
    const asked = this.#mannequins.get(character) ?? this.#asked(character);
    this.#mannequins.set(character, asked);
    asked.catch(() => this.#mannequins.delete(character));
    return { root: clone(await asked), vrm: null };
  }

  /**
   * The body in a file. Rejects with a NotABodyError where it is none.
   *
   * @param {File} file
   * @returns {Promise<Body>}
   */
  async avatar(file) {
    const loader = new GLTFLoader();
    loader.register((parser) => new VRMLoaderPlugin(parser));
    try {
      const content = await file.arrayBuffer();
      checkClaims(content);
      const { scene, userData } = await loader.parseAsync(content, "");
      const vrm = /** @type {VRM | null} */ (userData["vrm"] ?? null);
      return { root: facingUs(scene, vrm), vrm };
    } catch (error) {
      const reason = error instanceof Error ? error.message : String(error);
      throw new NotABodyError(`${file.name} is not a body in GLB or VRM: ${reason}`, { cause: error });
    }
  }

  /** @param {string} character */
  async #asked(character) {
    const form = new FormData();
    form.append("bml", new Blob([STANDING], { type: "application/xml" }), "standing.bml");
    form.append("options", JSON.stringify({ character, fps: 30 }));
    const request = { method: "POST", headers: { accept: "model/gltf-binary" }, body: form };
    const answer = await this.#service.fetch("realize", request);
    return (await new GLTFLoader().parseAsync(await answer.arrayBuffer(), "")).scene;
  }
}

/**
 * A body that faces +Z, in a group that may be turned on the stage. VRM 0 faces -Z.
 *
 * @param {Object3D} scene
 * @param {VRM | null} vrm
 */
function facingUs(scene, vrm) {
  if (vrm) {
    VRMUtils.rotateVRM0(vrm);
  }
  return new Group().add(scene);
}
