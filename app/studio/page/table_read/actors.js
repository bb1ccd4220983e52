/** Everybody on his mark: who speaks, who listens, and how they turn to one another from line to line. */

import { blended, clipFromGlb, clipFromJson, sampled } from "understudy-client";

import { Figure } from "../stage/figure.js";
import { lookingAside } from "./looking.js";
import { facing, turned } from "./marks.js";

/** @import { Clip, Pose } from "understudy-client" */
/** @import { Scene } from "three" */
/** @import { Bodies } from "../stage/bodies.js" */
/** @import { Mark } from "./marks.js" */
/** @import { SceneFiles } from "./scene_files.js" */
/** @import { SceneLine } from "./scene_index.js" */

/** @typedef {ReturnType<typeof facing>} Facing */

/** Whom he faced as the line began, and faces now. @typedef {{ name: string, figure: Figure, shown: Pose | null, from: Pose | null, faced: Facing, facing: Facing }} Actor */

/** @type {Facing} */
const AHEAD = Object.freeze({ body_rad: 0, gaze_rad: 0 });
const BLEND_S = 0.5;
const TURN_S = 0.8;
/** Whoever hears a line that was not performed for him does what its first listener does, so much later. */
const LATER_S = 0.25;

export class Actors {
  #failed;
  #files;
  #lines;
  #marks;
  /** @type {Actor[]} */
  #actors = [];
  /** @type {Map<string, Promise<Clip>>} */
  #asked = new Map();
  /** @type {Map<string, Clip>} */
  #clips = new Map();
  #line = -1;

  /**
   * @param {SceneFiles} files
   * @param {readonly SceneLine[]} lines
   * @param {ReadonlyMap<string, Mark>} marks
   * @param {(error: unknown) => void} failed is told of a clip that cannot be read
   */
  constructor(files, lines, marks, failed) {
    this.#failed = failed;
    this.#files = files;
    this.#lines = lines;
    this.#marks = marks;
  }

  /**
   * Has everybody stand in the scene; resolves when the first line can be shown.
   *
   * @param {Scene} scene
   * @param {Bodies} bodies
   * @param {ReadonlyMap<string, string>} cast
   */
  async enter(scene, bodies, cast) {
    const { joints } = await this.#clip(this.#lines[0]?.motion ?? "");
    for (const [name, character] of cast) {
      const figure = new Figure(await bodies.mannequin(character), joints);
      const { x, z } = this.#marks.get(name) ?? { x: 0, z: 0 };
      figure.root.position.set(x, 0, z);
      scene.add(figure.root);
      this.#actors.push({ name, figure, shown: null, from: null, faced: AHEAD, facing: AHEAD });
    }
    await this.prepare(0);
  }

  /** @param {Scene} scene */
  leave(scene) {
    this.#actors.forEach(({ figure }) => scene.remove(figure.root));
  }

  /**
   * Resolves when a line can be shown.
   *
   * @param {number} place
   */
  async prepare(place) {
    const line = this.#lines[place];
    await Promise.all(line ? [line.motion, ...line.listeners.values()].map((name) => this.#clip(name)) : []);
  }

  /**
   * Shows everybody at a time of a line, before its start as at it; whether it is there to be shown.
   *
   * @param {number} place of the line
   * @param {number} time_s after its start
   * @param {boolean} leaps whether the scene did not come to this line by itself
   */
  show(place, time_s, leaps) {
    const line = this.#lines[place];
    if (!line || !this.#clips.has(line.motion)) {
      this.prepare(place).catch(this.#failed);
      return false;
    }
    if (place !== this.#line) {
      this.#line = place;
      this.#actors.forEach((actor) => this.#begin(actor, leaps));
      this.prepare(place + 1).catch(this.#failed);
    }
    const turn = { speaker: line.speaker, listeners: [...line.listeners.keys()] };
    for (const actor of this.#actors) {
      const to = facing(actor.name, turn, this.#marks);
      actor.facing = actor.from ? between(actor.faced, to, Math.min(1, Math.max(0, time_s / TURN_S))) : to;
      actor.figure.root.rotation.y = actor.facing.body_rad;
      this.#pose(actor, line, time_s);
    }
    return true;
  }

  /** The height of the eyes of the first who came in, metres. */
  get eyes_m() {
    return (this.#actors[0]?.figure.place("head")?.y ?? 1.54) + 0.06;
  }

  /** Where the wrists of all are, metres. */
  get wrists() {
    return this.#actors.flatMap(({ figure }) => figure.place("rightHand")?.toArray() ?? []);
  }

  /**
   * @param {Actor} actor
   * @param {boolean} leaps
   */
  #begin(actor, leaps) {
    actor.from = leaps ? null : actor.shown;
    actor.faced = actor.facing;
  }

  /**
   * @param {Actor} actor
   * @param {SceneLine} line
   * @param {number} time_s
   */
  #pose(actor, line, time_s) {
    const own = actor.name === line.speaker ? line.motion : line.listeners.get(actor.name);
    const clip = this.#clips.get(own ?? [...line.listeners.values()][0] ?? "");
    if (!clip) {
      return;
    }
    const at_s = time_s - clip.audioOffsetS - (own ? 0 : LATER_S);
    const pose = sampled(clip, at_s);
    actor.shown = actor.from && time_s < BLEND_S ? blended(actor.from, pose, time_s / BLEND_S) : pose;
    const { body_rad, gaze_rad } = actor.facing;
    actor.figure.pose(lookingAside(actor.shown, turned(0, gaze_rad - body_rad, 1)), at_s);
  }

  /** @param {string} name */
  async #clip(name) {
    const asked = this.#asked.get(name) ?? this.#loaded(name);
    this.#asked.set(name, asked);
    const clip = await asked;
    this.#clips.set(name, clip);
    return clip;
  }

  /** @param {string} name */
  async #loaded(name) {
    const file = this.#files.get(name) ?? new Blob();
    return name.endsWith(".glb") ? clipFromGlb(await file.arrayBuffer()) : clipFromJson(JSON.parse(await file.text()));
  }
}

/**
 * @param {Facing} from
 * @param {Facing} to
 * @param {number} share
 * @returns {Facing}
 */
function between(from, to, share) {
  return { body_rad: turned(from.body_rad, to.body_rad, share), gaze_rad: turned(from.gaze_rad, to.gaze_rad, share) };
}
