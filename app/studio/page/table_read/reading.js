/** A scene that is read: everybody, the recordings and the camera, at the time of its clock. */

import { cutAt, cutsOf } from "./cuts.js";
import { Actors } from "./actors.js";
import { facing, marksOf, turned } from "./marks.js";
import { SceneClock } from "./scene_clock.js";
import { castOf, sceneOf } from "./scene_index.js";
import { spansOf } from "./sequence.js";
import { viewOf } from "./shots.js";

/** @import { Bodies } from "../stage/bodies.js" */
/** @import { Place } from "../stage/scene.js" */
/** @import { Shot } from "../stage/framing.js" */
/** @import { Cut } from "./cuts.js" */
/** @import { SceneFiles } from "./scene_files.js" */
/** @import { IndexLine } from "./scene_index.js" */

/** @typedef {Readonly<{ script?: string, lines: readonly IndexLine[] }>} SceneIndex */

/** The camera by itself, one shot of whoever speaks, or where the pointer has it. @typedef {"automatic" | Shot | "free"} Camera */

/** @type {readonly (readonly [Camera, string])[]} */
export const CAMERAS = Object.freeze([
  ["automatic", "Automatic cuts"],
  ["wide", "Everybody"],
  ["medium", "Whoever speaks"],
  ["close", "Whoever speaks, close"],
  ["two_shot", "Two-shot"],
  ["over_shoulder", "Over the listener's shoulder"],
  ["free", "Free"],
]);

export class Reading {
  /** @type {Camera} */
  camera = "automatic";
  /** The script that the scene is of. */
  script = "";
  #place;
  #actors;
  #cuts;
  #shown_s = NaN;
  /** @type {Camera | null} */
  #looked = null;

  /**
   * Rejects where the folder lacks what is needed.
   *
   * @param {SceneFiles} files
   * @param {Place} place
   * @param {Bodies} bodies
   * @param {(error: unknown) => void} failed is told of a clip that cannot be read later
   */
  static async open(files, place, bodies, failed) {
    const index = /** @type {SceneIndex} */ (JSON.parse((await files.get("index.json")?.text()) ?? ""));
    const reading = new Reading(files, sceneOf(index, new Set(files.keys())), place, failed);
    reading.script = index.script ?? "";
    await reading.#actors.enter(place.scene, bodies, castOf(reading.lines));
    return reading;
  }

  /**
   * @param {SceneFiles} files
   * @param {ReturnType<typeof sceneOf>} lines
   * @param {Place} place
   * @param {(error: unknown) => void} failed
   */
  constructor(files, lines, place, failed) {
    this.files = files;
    this.lines = lines;
    this.spans = spansOf(lines);
    this.marks = marksOf([...castOf(lines).keys()]);
    this.#place = place;
    this.#actors = new Actors(files, lines, this.marks, failed);
    this.#cuts = cutsOf(lines, this.spans);
    const sounds = lines.map(({ sound }) => URL.createObjectURL(files.get(sound) ?? new Blob()));
    this.close = () => {
      this.clock.seek(0);
      this.#actors.leave(place.scene);
      sounds.forEach((address) => URL.revokeObjectURL(address));
    };
    this.clock = new SceneClock(new Audio(), this.spans, sounds);
  }

  /**
   * Has everybody and the camera as they are at this moment; whether that is another than before.
   *
   * @param {number} now_ms
   */
  show(now_ms) {
    this.clock.update(now_ms);
    const { time_s, line, playing } = this.clock;
    const cut = this.#cut();
    if (time_s === this.#shown_s && this.camera === this.#looked) {
      return false;
    }
    [this.#shown_s, this.#looked] = [time_s, this.camera];
    this.#aim(cut);
    return this.#actors.show(line, time_s - (this.spans[line]?.start_s ?? 0), !playing) || this.#later();
  }

  /** What is not there yet is shown as soon as it is. */
  #later() {
    this.#shown_s = NaN;
    return false;
  }

  /** What the camera shows. @returns {Cut | null} */
  #cut() {
    const { time_s, line } = this.clock;
    if (this.camera === "free") {
      return null;
    }
    if (this.camera === "automatic") {
      return cutAt(this.#cuts, time_s) ?? null;
    }
    const { speaker = "", listeners } = this.lines[line] ?? {};
    return { from_s: 0, shot: this.camera, subject: speaker, beside: listeners ? ([...listeners.keys()][0] ?? null) : null };
  }

  /** The shot that is on and of whom, and where wrists are, for whoever looks. */
  get state() {
    const cut = this.#cut();
    const wrists = this.#actors.wrists.map((metres) => metres.toFixed(3)).join(" ");
    return { shot: cut ? `${cut.shot} ${cut.subject}` : "free", wrists };
  }

  /** @param {Cut | null} cut */
  #aim(cut) {
    const subject = this.marks.get(cut?.subject ?? "");
    if (!cut || !subject) {
      return;
    }
    const partner = this.marks.get(cut.beside ?? "");
    const rest = [...this.marks.values()].filter((mark) => mark !== subject && mark !== partner);
    const shown = { ...subject, facing_rad: this.#facing(cut.subject) };
    const picture = { aspect: this.#place.camera.aspect, eyes_m: this.#actors.eyes_m };
    const { from_m, at_m } = viewOf(cut.shot, shown, partner ? [partner, ...rest] : rest, picture);
    this.#place.camera.position.set(...from_m);
    this.#place.controls.target.set(...at_m);
    this.#place.controls.update();
  }

  /**
   * Which way somebody faces while the line of now is spoken: between his body and his gaze.
   *
   * @param {string} name
   */
  #facing(name) {
    const line = this.lines[this.clock.line];
    const turn = { speaker: line?.speaker ?? "", listeners: [...(line?.listeners.keys() ?? [])] };
    const { gaze_rad, body_rad } = facing(name, turn, this.marks);
    return turned(body_rad, gaze_rad, 0.5);
  }
}
