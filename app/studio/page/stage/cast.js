/** Has figures stand on the stage as roles say. Bodies stay while their role has the same character and avatar. */

import { Figure } from "./figure.js";

/** @import { Scene } from "three" */
/** @import { Bodies } from "./bodies.js" */
/** @import { Role } from "./figure.js" */

/** @typedef {{ role: Role, figure: Figure }} Standing */

export class Cast {
  #scene;
  #bodies;
  /** @type {Standing[]} */
  #standing = [];
  #latest = 0;

  /**
   * @param {Scene} scene
   * @param {Bodies} bodies
   */
  constructor(scene, bodies) {
    this.#scene = scene;
    this.#bodies = bodies;
  }

  /** Who stands there now. @returns {readonly Standing[]} */
  get standing() {
    return this.#standing;
  }

  /**
   * Resolves when they stand there, or others were asked for meanwhile. Rejects where a body cannot be had.
   *
   * @param {readonly Role[]} roles
   */
  async take(roles) {
    const turn = ++this.#latest;
    const next = await Promise.all(roles.map((role) => this.#figureFor(role)));
    if (turn !== this.#latest) {
      return;
    }
    for (const { figure } of this.#standing) {
      this.#scene.remove(figure.root);
    }
    this.#standing = next;
    for (const { role, figure } of next) {
      figure.root.position.set(...role.place_m);
      figure.root.rotation.y = role.turn_rad;
      this.#scene.add(figure.root);
    }
  }

  /**
   * Shows everybody at a time of the performance.
   *
   * @param {number} time_s
   * @param {number} lead_in_s
   */
  show(time_s, lead_in_s) {
    for (const { role, figure } of this.#standing) {
      figure.show(role.motion, time_s - lead_in_s - role.motion.audioOffsetS);
    }
  }

  /**
   * @param {Role} role
   * @returns {Promise<Standing>}
   */
  async #figureFor(role) {
    const same = this.#standing.find(
      (each) => each.role.name === role.name && each.role.character === role.character && each.role.avatar === role.avatar,
    );
    if (same) {
      return { role, figure: same.figure };
    }
    const body = role.avatar ? await this.#bodies.avatar(role.avatar) : await this.#bodies.mannequin(role.character);
    return { role, figure: new Figure(body, role.motion.joints) };
  }
}
