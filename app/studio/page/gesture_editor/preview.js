/**
 * The body in the gesture editor: it stands in the pose of the frame that is looked at, or plays the gesture.
 *
 * The canvas has `data-level` (of the motion that is shown), `data-time` and `data-pose`, as the stage has.
 */

import { choice, el, labelled } from "../dom.js";
import { icon } from "../icons.js";
import { problemOf } from "../service/service.js";
import { AGITATION } from "../naming/movements.js";
import { PROBLEM } from "../state/performed.js";
import { Bodies } from "../stage/bodies.js";
import { viewOf } from "../stage/cameras.js";
import { Cast } from "../stage/cast.js";
import { makePlace } from "../stage/scene.js";
import { followTheme } from "../stage/theme.js";
import { MOTION, PREVIEW } from "./checking.js";
import { clipTime } from "./clip_time.js";
import { FRAME } from "./gestures.js";

/** @import { Service } from "../service/service.js" */
/** @import { Store } from "../state/store.js" */
/** @import { Level } from "./checking.js" */

const EYES_M = 1.55;

/**
 * @param {Store} store
 * @param {Service} service
 */
export function preview(store, service) {
  const canvas = el("canvas", { id: "gesture-canvas", tabindex: 0, role: "img", "aria-label": "The character makes the gesture" });
  const shown = new Shown(canvas, store, service);
  const frame = (/** @type {number} */ now_ms) => {
    shown.draw(now_ms);
    requestAnimationFrame(frame);
  };
  requestAnimationFrame(frame);
  return el("div", { class: "gesture-stage" }, [el("div", { class: "screen" }, [canvas]), controls(store)]);
}

/** @param {Store} store */
function controls(store) {
  const levels = choice(AGITATION, "medium", (level) => store.patch(PREVIEW, { level: /** @type {Level} */ (level) }));
  levels.id = "gesture-level";
  const play = el("button", { type: "button", id: "gesture-play", click: () => toggle(store) }, []);
  store.watch(PREVIEW, ({ playing }) => {
    play.setAttribute("aria-pressed", String(playing));
    play.replaceChildren(icon(playing ? "pause" : "play"), playing ? "Pause" : "Play");
  });
  return el("div", { class: "transport", role: "toolbar", "aria-label": "Playing the gesture" }, [play, labelled("Agitation", levels)]);
}

/** @param {Store} store */
function toggle(store) {
  store.patch(PREVIEW, { playing: !store.get(PREVIEW).playing });
}

/** What is drawn, and only while it can be seen and is another picture than before. */
class Shown {
  #canvas;
  #store;
  #place;
  #cast;
  #isStale = true;
  #time_s = 0;
  #level = "";
  #last_ms = 0;

  /**
   * @param {HTMLCanvasElement} canvas
   * @param {Store} store
   * @param {Service} service
   */
  constructor(canvas, store, service) {
    this.#canvas = canvas;
    this.#store = store;
    this.#place = makePlace(canvas, store);
    this.#cast = new Cast(this.#place.scene, new Bodies(service));
    this.#place.controls.addEventListener("change", () => (this.#isStale = true));
    this.#aim();
    followTheme(this.#place, () => (this.#isStale = true));
    store.watch(MOTION, () => void this.#recast());
    store.watch(FRAME, () => this.#rewind());
    store.watch(PREVIEW, () => this.#rewind());
  }

  /** @param {number} now_ms */
  draw(now_ms) {
    const passed_s = Math.min((now_ms - this.#last_ms) / 1000, 0.1);
    this.#last_ms = now_ms;
    if (!this.#canvas.checkVisibility()) {
      return;
    }
    this.#advance(passed_s);
    if (this.#place.fit() || this.#isStale) {
      this.#isStale = false;
      this.#cast.show(this.#time_s, 0);
      this.#place.draw();
      this.#tell();
    }
  }

  /** @param {number} passed_s */
  #advance(passed_s) {
    const motion = this.#store.get(MOTION);
    if (motion && this.#store.get(PREVIEW).playing) {
      const next_s = this.#time_s + passed_s;
      this.#time_s = next_s > motion.clip.durationS ? 0 : next_s;
      this.#isStale = true;
    }
  }

  #rewind() {
    const motion = this.#store.get(MOTION);
    const frame = motion?.gesture.frames[this.#store.get(FRAME)];
    if (motion && frame && !this.#store.get(PREVIEW).playing) {
      this.#time_s = clipTime(motion.gesture, motion.clip.events, frame.time);
    } else if (this.#store.get(PREVIEW).playing) {
      this.#time_s = 0;
    }
    this.#isStale = true;
  }

  async #recast() {
    const motion = this.#store.get(MOTION);
    if (!motion) {
      return;
    }
    const role = { name: "gesture", character: "default", motion: motion.clip, place_m: ORIGIN_M, turn_rad: 0, avatar: null };
    try {
      await this.#cast.take([role]);
    } catch (error) {
      this.#store.set(PROBLEM, problemOf(error));
    }
    this.#level = motion.level;
    if (!this.#store.get(PREVIEW).playing) {
      this.#rewind();
    }
    this.#isStale = true;
  }

  #aim() {
    const { from_m, at_m } = viewOf("medium", EYES_M, null);
    this.#place.camera.position.set(...from_m);
    this.#place.controls.target.set(...at_m);
    this.#place.controls.update();
  }

  #tell() {
    const [standing] = this.#cast.standing;
    const wrists = ["leftHand", "rightHand"].flatMap((joint) => standing?.figure.place(joint)?.toArray() ?? []);
    this.#canvas.dataset["pose"] = wrists.map((metres) => metres.toFixed(4)).join(" ");
    this.#canvas.dataset["time"] = this.#time_s.toFixed(3);
    this.#canvas.dataset["level"] = this.#level;
  }
}

/** @type {import("understudy-client").Vector} */
const ORIGIN_M = [0, 0, 0];
