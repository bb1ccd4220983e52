/** The path of each wrist around the playhead while it gestures, coloured by the phases as they are played. */

import { BufferAttribute, BufferGeometry, Color, Group, Line, LineBasicMaterial, Points, PointsMaterial } from "three";

import { PHASE_COLOURS, phasesOf, playedSync } from "../timeline/phases.js";
import { wristPath } from "./wrist_path.js";

/** @import { Behavior, Clip } from "understudy-client" */
/** @import { Phase } from "../timeline/phases.js" */
/** @import { Side } from "./wrist_path.js" */

const RATE_HZ = 60;
const BEFORE_S = 1.2;
const AFTER_S = 0.3;

/** The path of one gesture of a wrist, from one time to another. @typedef {Readonly<{ geometry: BufferGeometry, start_s: number, end_s: number }>} Path */

/** An object for the scene, which shows what `show` says. */
export class Trail {
  group = new Group();
  /** @type {readonly Path[]} */
  #paths = [];

  /**
   * Takes the paths of a clip whose gestures are these.
   *
   * @param {Clip} clip
   * @param {readonly Behavior[]} behaviors
   */
  take(clip, behaviors) {
    this.clear();
    this.#paths = (/** @type {const} */ (["left", "right"])).flatMap((side) => pathsOf(clip, behaviors, side));
    for (const { geometry } of this.#paths) {
      const line = new Line(geometry, new LineBasicMaterial({ vertexColors: true }));
      const dots = new Points(geometry, new PointsMaterial({ vertexColors: true, size: 5, sizeAttenuation: false }));
      line.frustumCulled = dots.frustumCulled = false;
      this.group.add(line, dots);
    }
  }

  /** @param {number} time_s after the clip's first frame */
  show(time_s) {
    for (const { geometry, start_s, end_s } of this.#paths) {
      const isMoving = time_s > start_s && time_s < end_s + AFTER_S;
      const from_s = Math.max(start_s, time_s - BEFORE_S);
      const first = Math.round((from_s - start_s) * RATE_HZ);
      const last = Math.round((Math.min(end_s, time_s + AFTER_S) - start_s) * RATE_HZ);
      geometry.setDrawRange(first, isMoving ? Math.max(0, last - first) : 0);
    }
  }

  clear() {
    this.group.clear();
    for (const { geometry } of this.#paths) {
      geometry.dispose();
    }
    this.#paths = [];
  }
}

/**
 * @param {Clip} clip
 * @param {readonly Behavior[]} behaviors
 * @param {Side} side
 * @returns {Path[]}
 */
function pathsOf(clip, behaviors, side) {
  const places = wristPath(clip, side, RATE_HZ);
  return behaviors
    .filter(({ kind, hand, kept }) => kept && kind === "gesture" && (hand === side || hand === "both"))
    .map(({ id }) => phasesOf(playedSync(clip.events, id)))
    .flatMap((phases) => (phases.length > 0 ? [pathOf(places, phases)] : []));
}

/**
 * @param {ReturnType<typeof wristPath>} places
 * @param {readonly Phase[]} phases
 * @returns {Path}
 */
function pathOf(places, phases) {
  const [start_s, end_s] = [phases[0]?.start_s ?? 0, phases.at(-1)?.end_s ?? 0];
  const first = Math.max(0, Math.round(start_s * RATE_HZ));
  const own = places.slice(first, Math.round(end_s * RATE_HZ) + 1);
  const colours = own.flatMap((_, index) => {
    const time_s = (first + index) / RATE_HZ;
    const phase = phases.find((each) => time_s < each.end_s) ?? phases.at(-1);
    return new Color(phase && PHASE_COLOURS[phase.name]).toArray();
  });
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(new Float32Array(own.flat()), 3));
  geometry.setAttribute("color", new BufferAttribute(new Float32Array(colours), 3));
  return { geometry, start_s: first / RATE_HZ, end_s };
}
