/** Plays a clip: the character on the stage, its motion led by the recording. */

import { Mesh, MeshBasicMaterial, SphereGeometry } from "three";
import { GLTFLoader } from "three/addons/loaders/GLTFLoader.js";
import { clipFromJson } from "understudy-client";

import { viewOf } from "../../studio/page/stage/cameras.js";
import { Figure } from "../../studio/page/stage/figure.js";
import { makePlace } from "../../studio/page/stage/scene.js";
import { Store } from "../../studio/page/state/store.js";
import { fileNamed } from "./files.js";

/** @import { Clip } from "understudy-client" */
/** @import { Round } from "./plan.js" */

const EYES_M = 1.6;
const MASK = 0x8c9499;

export class Player {
  #place;
  #audio = new Audio();
  #hidesFace;
  /** @type {Map<string, Promise<Figure>>} */
  #figures = new Map();
  /** @type {Figure | null} */
  #figure = null;
  /** @type {Clip | null} */
  #clip = null;
  #turn = 0;
  #ended_ms = 0;
  #shown_s = NaN;

  /**
   * @param {HTMLCanvasElement} canvas
   * @param {boolean} hidesFace
   */
  constructor(canvas, hidesFace) {
    this.#place = makePlace(canvas, new Store());
    this.#place.controls.enabled = false;
    this.#hidesFace = hidesFace;
    const { from_m, at_m } = viewOf("medium", EYES_M, [0, EYES_M, 1.7]);
    this.#place.camera.position.set(...from_m);
    this.#place.controls.target.set(...at_m);
    this.#place.controls.update();
    const draw = () => {
      this.#draw();
      requestAnimationFrame(draw);
    };
    draw();
  }

  /**
   * Has a clip ready at its first frame. Rejects where a file is missing.
   *
   * @param {Round} round
   * @param {string} name of the clip
   */
  async load({ sound, body }, name) {
    this.stop();
    const turn = this.#turn;
    const clip = clipFromJson(JSON.parse(await fileNamed(name)));
    const figure = await this.#figureOf(body, clip);
    if (turn !== this.#turn) {
      return;
    }
    if (this.#figure) {
      this.#place.scene.remove(this.#figure.root);
    }
    this.#place.scene.add(figure.root);
    [this.#figure, this.#clip] = [figure, clip];
    const address = new URL(`clips/${sound}.flac`, location.href).href;
    if (this.#audio.src !== address) {
      this.#audio.src = address;
    }
    this.#audio.currentTime = 0;
    this.#shown_s = NaN;
  }

  /**
   * Plays from the start; resolves with whether it came to its end. Rejects where the recording cannot be played.
   *
   * @returns {Promise<boolean>}
   */
  async play() {
    const turn = this.#turn;
    await this.#audio.play();
    await new Promise((resolve) => this.#audio.addEventListener("ended", resolve, { once: true }));
    this.#ended_ms = performance.now();
    const { durationS = 0 } = this.#clip ?? {};
    const left_s = Math.max(0, durationS - this.#audio.duration);
    await new Promise((resolve) => setTimeout(resolve, left_s * 1000));
    return turn === this.#turn;
  }

  /** Ends what is played. */
  stop() {
    this.#turn += 1;
    this.#audio.pause();
  }

  /** Draws where something is other than it was drawn. */
  #draw() {
    const time_s = this.#time_s;
    if (!this.#place.fit() && time_s === this.#shown_s) {
      return;
    }
    this.#shown_s = time_s;
    if (this.#figure && this.#clip) {
      this.#figure.show(this.#clip, time_s - this.#clip.audioOffsetS);
    }
    this.#place.draw();
  }

  /** The recording's time, and after its end that of the motion. */
  get #time_s() {
    const after_s = this.#audio.ended ? (performance.now() - this.#ended_ms) / 1000 : 0;
    return Math.min(this.#clip?.durationS ?? 0, this.#audio.currentTime + after_s);
  }

  /**
   * @param {string} name
   * @param {Clip} clip
   */
  async #figureOf(name, clip) {
    const found = this.#figures.get(name) ?? this.#made(name, clip);
    this.#figures.set(name, found);
    return found;
  }

  /**
   * @param {string} name
   * @param {Clip} clip
   */
  async #made(name, clip) {
    const bytes = Uint8Array.from(atob(await fileNamed(name)), (each) => each.charCodeAt(0));
    const { scene } = await new GLTFLoader().parseAsync(bytes.buffer, "");
    const figure = new Figure({ root: scene, vrm: null }, clip.joints);
    if (this.#hidesFace) {
      scene.getObjectByName("head")?.add(mask());
    }
    return figure;
  }
}

/** What hides the head, in the space of its joint. */
function mask() {
  const made = new Mesh(new SphereGeometry(0.15, 24, 16), new MeshBasicMaterial({ color: MASK }));
  made.scale.set(0.85, 1.1, 1);
  made.position.set(0, 0.09, 0.02);
  return made;
}
