/** What is drawn of a motion around its body, where it is asked for: the paths of the wrists and the onion skin. */

import { OnionSkin } from "./onion_skin.js";
import { Trail } from "./trail.js";

/** @import { Scene } from "three" */
/** @import { PerformedLine } from "../state/performed.js" */
/** @import { Bodies } from "./bodies.js" */
/** @import { Viewing } from "./viewing.js" */

export class MotionDrawings {
  #trail = new Trail();
  #onion = new OnionSkin();
  #bodies;

  /**
   * @param {Scene} scene
   * @param {Bodies} bodies
   */
  constructor(scene, bodies) {
    this.#bodies = bodies;
    scene.add(this.#trail.group, this.#onion.group);
  }

  /**
   * Takes over a line. Rejects where its body cannot be had.
   *
   * @param {PerformedLine | null} line null where its own body is not on the stage
   * @param {Pick<Viewing, "trail" | "onion">} viewing
   */
  async take(line, { trail, onion }) {
    this.#trail.clear();
    if (line && trail) {
      this.#trail.take(line.motion, line.performance.behaviors);
    }
    if (line && onion) {
      const { performance, motion } = line;
      await this.#onion.take(this.#bodies, performance.character, { clip: motion, behaviors: performance.behaviors });
    } else {
      this.#onion.clear();
    }
  }

  /** @param {number} time_s after the clip's first frame */
  show(time_s) {
    this.#trail.show(time_s);
    this.#onion.show(time_s);
  }
}
