/**
 * The stage: shows the performed line, and whoever else `GUESTS` says, at the time of the playhead.
 *
 * The canvas has `data-roles` (who stands there), `data-time` (of what is shown, seconds), `data-pose` (where the wrists
 * of each are, metres from where he stands) and `data-casts` (how often somebody was cast) for tests and benchmarks.
 */

import { selectedBehavior } from "../changes/behaviors.js";
import { el } from "../dom.js";
import { problemOf } from "../service/service.js";
import { AVATAR, PERFORMED, PLAYBACK, PROBLEM, SELECTION, TIME_S } from "../state/performed.js";
import { Bodies, NotABodyError } from "./bodies.js";
import { viewOf } from "./cameras.js";
import { Cast } from "./cast.js";
import { Clock } from "./clock.js";
import { MotionDrawings } from "./motion_drawings.js";
import { NameTags, namedOf } from "./name_tags.js";
import { recordingOf } from "./recording.js";
import { makePlace } from "./scene.js";
import { followTheme } from "./theme.js";
import { mountTransport } from "./transport.js";
import { CHARACTERS, COMPARED_NAME, GUESTS, rolesOf, SCREEN, showsGuests, VIEWING } from "./viewing.js";

/** @import { Service } from "../service/service.js" */
/** @import { Store } from "../state/store.js" */
/** @import { Size } from "./picturing.js" */

const EYES_M = 1.55;
const WRISTS = Object.freeze(["leftHand", "rightHand"]);

/**
 * @param {HTMLElement} element
 * @param {Store} store
 * @param {Service} service
 */
export function mountStage(element, store, service) {
  const canvas = el("canvas", { id: "stage-canvas", tabindex: 0, role: "img", "aria-label": "The character performs the line" });
  const controls = el("div", { class: "transport", role: "toolbar", "aria-label": "Playing" });
  const audio = recordingOf(store);
  const stage = new Stage(canvas, store, service);
  const safe = el("div", { class: "safe", hidden: true });
  store.watch(VIEWING, (viewing) => (safe.hidden = !viewing.safe));
  element.append(el("div", { class: "screen" }, [canvas, safe, stage.tags.element]), controls, audio);
  mountTransport(controls, store);
  store.set(SCREEN, { canvas, audio, draw: () => stage.picture(), fix: (size) => stage.fix(size) });
  runFrames(new Clock(store, audio), stage);
}

/**
 * @param {Clock} clock
 * @param {Stage} stage
 */
function runFrames(clock, stage) {
  const frame = (/** @type {number} */ now_ms) => {
    clock.update(now_ms);
    stage.draw();
    requestAnimationFrame(frame);
  };
  requestAnimationFrame(frame);
}

/** What is drawn, and only where it is another picture than before. */
class Stage {
  #canvas;
  #store;
  #place;
  #cast;
  #drawings;
  tags = new NameTags();
  #isStale = true;
  #isOrbited = false;
  #aimed = "";
  #casts = 0;

  /**
   * @param {HTMLCanvasElement} canvas
   * @param {Store} store
   * @param {Service} service
   */
  constructor(canvas, store, service) {
    this.#canvas = canvas;
    this.#store = store;
    this.#place = makePlace(canvas, store);
    const bodies = new Bodies(service);
    this.#cast = new Cast(this.#place.scene, bodies);
    this.#drawings = new MotionDrawings(this.#place.scene, bodies);
    const stale = () => (this.#isStale = true);
    this.#place.controls.addEventListener("change", stale);
    this.#place.controls.addEventListener("start", () => (this.#isOrbited = true));
    followTheme(this.#place, stale);
    for (const of of [TIME_S, SELECTION, PLAYBACK]) {
      store.watch(/** @type {typeof TIME_S} */ (of), stale);
    }
    for (const of of [PERFORMED, AVATAR, GUESTS]) {
      store.watch(/** @type {typeof AVATAR} */ (of), () => void this.#recast());
    }
    store.watch(VIEWING, () => void this.#recast());
    this.#aim();
  }

  /** @param {Size | null} size of pictures; null for that of the stage */
  fix(size) {
    this.#place.fix(size);
  }

  /** @param {() => void} [drawn] draws the place: `picture` draws it finely */
  draw(drawn = this.#place.draw) {
    const isResized = this.#place.fit();
    if (isResized && !this.#isOrbited) {
      this.#aim();
    }
    if (isResized || this.#isStale) {
      this.#isStale = false;
      this.#pose();
      this.#pointOut();
      drawn();
      this.#tell();
    }
  }

  picture() {
    this.draw(this.#place.picture);
  }

  #pose() {
    const line = this.#store.get(PERFORMED);
    const time_s = this.#store.get(TIME_S);
    const lead_in_s = line?.performance.lead_in_s ?? 0;
    this.#cast.show(time_s, lead_in_s);
    this.#drawings.show(time_s - lead_in_s - (line?.motion.audioOffsetS ?? 0));
  }

  /** The part of the body that makes what is selected glows, and several bodies have names. */
  #pointOut() {
    const { standing } = this.#cast;
    const isStill = !this.#store.get(PLAYBACK).playing;
    const behavior = isStill ? selectedBehavior(this.#store) : null;
    standing.forEach(({ role, figure }) => figure.glow.show(role.name === "speaker" && behavior?.kept ? behavior : null));
    this.#place.camera.updateMatrixWorld();
    this.tags.show(namedOf(standing, this.#store.get(COMPARED_NAME)), this.#place.camera);
  }

  async #recast() {
    const line = this.#store.get(PERFORMED);
    const viewing = this.#store.get(VIEWING);
    const { listening } = viewing;
    const avatar = this.#store.get(AVATAR);
    const roles = line ? rolesOf(line, listening, avatar, this.#store.get(CHARACTERS)) : [];
    try {
      await this.#cast.take([...roles, ...(showsGuests(viewing) ? this.#store.get(GUESTS) : [])]);
      await this.#drawings.take(listening !== "instead" && !avatar ? line : null, viewing);
    } catch (error) {
      this.#store.set(PROBLEM, problemOf(error));
      if (error instanceof NotABodyError) {
        this.#store.set(AVATAR, null);
      }
    }
    this.#casts += 1;
    this.#isStale = true;
    this.#aimAnew();
  }

  /** Aims where another shot is wanted or others stand there: else the camera stays where the author has it. */
  #aimAnew() {
    const { shot } = this.#store.get(VIEWING);
    const key = JSON.stringify([shot, this.#cast.standing.map(({ role }) => [role.name, role.character, role.place_m])]);
    if (key !== this.#aimed) {
      this.#aimed = key;
      this.#aim();
    }
  }

  #aim() {
    this.#isOrbited = false;
    const guests = this.#store.get(GUESTS);
    const { standing } = this.#cast;
    const listener = standing.slice(1).find(({ role }) => !guests.includes(role));
    const [head, listening] = [standing[0], listener].map((each) => each?.figure.place("head")?.toArray() ?? null);
    const eyes_m = head ? head[1] + 0.06 : EYES_M;
    const extra_m = guests[0]?.place_m[0] ?? 0;
    const picture = { aspect: this.#place.camera.aspect, extra_m };
    const { from_m, at_m } = viewOf(this.#store.get(VIEWING).shot, eyes_m, listening ?? null, picture);
    this.#place.camera.position.set(...from_m);
    this.#place.controls.target.set(...at_m);
    this.#place.controls.update();
    this.#isStale = true;
  }

  #tell() {
    const { standing } = this.#cast;
    const wrists = standing.flatMap(({ figure }) => WRISTS.flatMap((joint) => figure.place(joint)?.sub(figure.root.position).toArray() ?? []));
    this.#canvas.dataset["time"] = String(this.#store.get(TIME_S));
    this.#canvas.dataset["casts"] = String(this.#casts);
    this.#canvas.dataset["roles"] = standing.map(({ role }) => role.name).join(" ");
    this.#canvas.dataset["pose"] = wrists.map((metres) => metres.toFixed(4)).join(" ");
  }
}
