/**
 * Gestures as small moving figures of lines: the service plays each on our body the first time that it is seen, and until
 * then the figure stands. Where motion is to be reduced it holds the gesture's stroke.
 */

import { Quaternion, Vector3 } from "three";
import { clipFromJson, sampled } from "understudy-client";

import { el } from "../dom.js";

/** @import { Clip, Pose } from "understudy-client" */
/** @import { Service } from "../service/service.js" */

const SIZE_PX = 96;
const START_S = 0.2;
const FRAMES_PER_SECOND = 15;
const CENTRE_M = Object.freeze([0, 1.22]);
const HEIGHT_M = 1.3;
const HEAD_M = 0.1;
const LEGS = /leg|foot|toes/i;

/** Clips of gestures by lexeme, each asked for once and one after the other: the line itself is not to wait for them. */
export class GestureClips {
  /** @type {Map<string, Promise<Clip>>} */
  #clips = new Map();
  /** @type {Promise<unknown>} */
  #last = Promise.resolve();
  /** Whether somebody who asked for a gesture still wants it, by lexeme. @type {Map<string, (() => boolean)[]>} */
  #wanted = new Map();
  #service;

  /** @param {Service} service */
  constructor(service) {
    this.#service = service;
  }

  /**
   * Rejects where the service does not play it, or nobody wants it any more when its turn comes.
   *
   * @param {string} lexeme
   * @param {() => boolean} isWanted
   * @returns {Promise<Clip>}
   */
  of(lexeme, isWanted) {
    const known = this.#clips.get(lexeme);
    this.#wanted.set(lexeme, [...(this.#wanted.get(lexeme) ?? []), isWanted]);
    if (known) {
      return known;
    }
    const asked = this.#last.then(() => this.#inTurn(lexeme));
    this.#clips.set(lexeme, asked);
    this.#last = asked.catch(() => this.#clips.delete(lexeme));
    return asked;
  }

  /** @param {string} lexeme */
  #inTurn(lexeme) {
    const isWanted = this.#wanted.get(lexeme)?.some((each) => each());
    this.#wanted.delete(lexeme);
    return isWanted ? this.#asked(lexeme) : Promise.reject(new Error("nobody wants it"));
  }

  /** @param {string} lexeme */
  async #asked(lexeme) {
    const form = new FormData();
    form.append("bml", new Blob([played(lexeme)], { type: "application/xml" }), "gesture.bml");
    form.append("options", JSON.stringify({ fps: 30, stillness: 0 }));
    const answer = await this.#service.fetch("realize", { method: "POST", headers: { accept: "application/json" }, body: form });
    return clipFromJson(await answer.json());
  }
}

/** @param {string} lexeme */
function played(lexeme) {
  const root = document.implementation.createDocument("http://www.bml-initiative.org/bml/bml-1.0", "bml");
  const gesture = root.createElementNS(root.documentElement.namespaceURI, "gesture");
  root.documentElement.setAttribute("id", "shown");
  for (const [name, value] of Object.entries({ id: "gesture", lexeme, start: String(START_S) })) {
    gesture.setAttribute(name, value);
  }
  root.documentElement.append(gesture);
  return new XMLSerializer().serializeToString(root);
}

/**
 * A canvas that plays a gesture again and again while it is on the page and seen.
 *
 * @param {GestureClips} clips
 * @param {string} lexeme
 */
export function thumbnail(clips, lexeme) {
  const canvas = el("canvas", { width: SIZE_PX, height: SIZE_PX, "aria-hidden": "true", "data-lexeme": lexeme });
  requestAnimationFrame(() => canvas.dataset["played"] === undefined && drawStanding(canvas));
  const seen = new IntersectionObserver(([entry]) => {
    if (entry?.isIntersecting) {
      seen.disconnect();
      clips.of(lexeme, () => canvas.isConnected).then((clip) => play(canvas, clip), () => canvas.classList.add("unplayed"));
    }
  });
  seen.observe(canvas);
  return canvas;
}

/** Somebody who stands, until the gesture is there: lines on a square of 96 × 96. */
const STANDING = Object.freeze([[[48, 24], [48, 70]], [[33, 33], [63, 33]], [[33, 33], [30, 52], [34, 70]], [[63, 33], [66, 52], [62, 70]], [[41, 70], [55, 70]]]);

/** @param {HTMLCanvasElement} canvas */
function drawStanding(canvas) {
  const pen = canvas.getContext("2d");
  if (pen) {
    pen.strokeStyle = getComputedStyle(canvas).color;
    pen.globalAlpha = 0.4;
    pen.lineWidth = 2;
    pen.stroke(new Path2D(STANDING.map((line) => `M${line.map((point) => point.join(" ")).join("L")}`).join("")));
    pen.beginPath();
    pen.arc(48, 16, pixels(HEAD_M), 0, 2 * Math.PI);
    pen.stroke();
    pen.globalAlpha = 1;
  }
}

/**
 * @param {HTMLCanvasElement} canvas
 * @param {Clip} clip
 */
function play(canvas, clip) {
  const stroke_s = clip.events.find(({ point }) => point === "stroke")?.timeS ?? clip.durationS / 2;
  canvas.dataset["played"] = "";
  if (matchMedia("(prefers-reduced-motion: reduce)").matches) {
    draw(canvas, clip, stroke_s);
    return;
  }
  const frame = (/** @type {number} */ now_ms) => {
    if (canvas.isConnected) {
      draw(canvas, clip, (Math.floor((now_ms / 1000) * FRAMES_PER_SECOND) / FRAMES_PER_SECOND) % clip.durationS);
      requestAnimationFrame(frame);
    }
  };
  requestAnimationFrame(frame);
}

/**
 * @param {HTMLCanvasElement} canvas
 * @param {Clip} clip
 * @param {number} time_s
 */
function draw(canvas, clip, time_s) {
  const pen = canvas.getContext("2d");
  if (!pen) {
    return;
  }
  const places = placesOf(clip, sampled(clip, time_s));
  pen.clearRect(0, 0, SIZE_PX, SIZE_PX);
  pen.strokeStyle = getComputedStyle(canvas).color;
  pen.lineWidth = 2;
  for (const { name, parent } of clip.joints) {
    const [from, to] = [places.get(parent ?? ""), places.get(name)];
    if (from && to && !LEGS.test(name)) {
      pen.beginPath();
      pen.moveTo(...from);
      pen.lineTo(...to);
      pen.stroke();
    }
  }
  const head = places.get("head");
  if (head) {
    pen.beginPath();
    pen.arc(head[0], head[1] - pixels(HEAD_M), pixels(HEAD_M), 0, 2 * Math.PI);
    pen.stroke();
  }
}

/**
 * Where joints are on the canvas, seen from the listener.
 *
 * @param {Clip} clip
 * @param {Pose} pose
 */
function placesOf(clip, pose) {
  /** @type {Map<string, { at: Vector3, turn: Quaternion }>} */
  const placed = new Map();
  /** @type {Map<string, [number, number]>} */
  const places = new Map();
  for (const { name, parent, offsetM } of clip.joints) {
    const above = placed.get(parent ?? "");
    const own = new Quaternion(...(pose.turns.get(name) ?? [0, 0, 0, 1]));
    const at = above ? new Vector3(...offsetM).applyQuaternion(above.turn).add(above.at) : new Vector3(...pose.hipsM);
    placed.set(name, { at, turn: above ? above.turn.clone().multiply(own) : own });
    places.set(name, [SIZE_PX / 2 + pixels(at.x - (CENTRE_M[0] ?? 0)), SIZE_PX / 2 - pixels(at.y - (CENTRE_M[1] ?? 0))]);
  }
  return places;
}

/** @param {number} metres */
function pixels(metres) {
  return (metres / HEIGHT_M) * SIZE_PX;
}
