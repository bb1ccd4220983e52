/** The way of each wrist around the playhead, coloured by the phases of its gestures as they are played. */

import { BufferAttribute, BufferGeometry, Color, Group, Line, LineBasicMaterial, Points, PointsMaterial } from "three";

import { PHASE_COLOURS, phasesOf, playedSync } from "../timeline/phases.js";
import { wristPath } from "./wrist_path.js";

/** @import { Behavior, Clip } from "understudy-client" */
/** @import { Side } from "./wrist_path.js" */

const RATE_HZ = 60;
const BEFORE_S = 1.2;
const AFTER_S = 0.3;
const NO_GESTURE = "#7d858a";

/** An object for the scene, which shows what `show` says. */
export class Trail {
  group = new Group();
  /** @type {BufferGeometry[]} */
  #paths = [];

  /**
   * Takes the ways of a clip whose gestures are these.
   *
   * @param {Clip} clip
   * @param {readonly Behavior[]} behaviors
   */
  take(clip, behaviors) {
    this.clear();
    this.#paths = (/** @type {const} */ (["left", "right"])).map((side) => wayOf(clip, behaviors, side));
    for (const path of this.#paths) {
      const line = new Line(path, new LineBasicMaterial({ vertexColors: true }));
      const dots = new Points(path, new PointsMaterial({ vertexColors: true, size: 5, sizeAttenuation: false }));
      line.frustumCulled = dots.frustumCulled = false;
      this.group.add(line, dots);
    }
  }

  /** @param {number} time_s after the clip's first frame */
  show(time_s) {
    const first = Math.max(0, Math.round((time_s - BEFORE_S) * RATE_HZ));
    const last = Math.round((time_s + AFTER_S) * RATE_HZ);
    for (const path of this.#paths) {
      path.setDrawRange(first, Math.max(0, last - first));
    }
  }

  clear() {
    this.group.clear();
    for (const path of this.#paths) {
      path.dispose();
    }
    this.#paths = [];
  }
}

/**
 * @param {Clip} clip
 * @param {readonly Behavior[]} behaviors
 * @param {Side} side
 */
function wayOf(clip, behaviors, side) {
  const places = wristPath(clip, side, RATE_HZ);
  const phases = behaviors
    .filter(({ kind, hand, kept }) => kept && kind === "gesture" && (hand === side || hand === "both"))
    .flatMap(({ id }) => phasesOf(playedSync(clip.events, id)));
  const colours = places.flatMap((_, index) => {
    const time_s = index / RATE_HZ;
    const phase = phases.find(({ start_s, end_s }) => start_s <= time_s && time_s < end_s);
    return new Color(phase ? PHASE_COLOURS[phase.name] : NO_GESTURE).toArray();
  });
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(new Float32Array(places.flat()), 3));
  geometry.setAttribute("color", new BufferAttribute(new Float32Array(colours), 3));
  return geometry;
}
