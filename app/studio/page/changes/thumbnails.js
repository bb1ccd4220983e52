/**
 * Gestures as small moving figures of lines: the service plays each on our body the first time that it is seen, and until
 * then the figure stands. Where motion is to be reduced it holds the gesture's stroke.
 */

import { Quaternion, Vector3 } from "three";
import { sampled } from "understudy-client";

import { el } from "../dom.js";

/** @import { Clip, Pose } from "understudy-client" */
/** @import { GestureClips } from "./gesture_clips.js" */

const SIZE_PX = 192;
const FRAMES_PER_SECOND = 15;
const CENTRE_M = Object.freeze([0, 1.3]);
const HEIGHT_M = 1.12;
const LINE_PX = 7;
const HEAD_M = 0.1;
const LEGS = /leg|foot|toes/i;
const FINGERS = /thumb|index|middle|ring|little|pinky/i;

/**
 * A canvas that plays a gesture again and again while it is on the page and seen.
 *
 * @param {GestureClips} clips
 * @param {string} lexeme
 */
export function thumbnail(clips, lexeme) {
  const canvas = el("canvas", { width: SIZE_PX, height: SIZE_PX, "aria-hidden": "true", "data-lexeme": lexeme });
  requestAnimationFrame(() => canvas.dataset["played"] === undefined && drawStanding(canvas));
  let isSeen = false;
  let isAsked = false;
  const watching = new IntersectionObserver(([entry]) => {
    isSeen = entry?.isIntersecting ?? false;
    if (isSeen && !isAsked) {
      isAsked = true;
      clips.of(lexeme, () => canvas.isConnected).then((clip) => play(canvas, clip, () => isSeen), () => canvas.classList.add("unplayed"));
    }
  });
  watching.observe(canvas);
  return canvas;
}

/** Somebody who stands, until the gesture is there: lines on a square of 192 × 192. */
const STANDING = Object.freeze([[[96, 62], [96, 160]], [[66, 80], [126, 80]], [[66, 80], [58, 122], [68, 158]], [[126, 80], [134, 122], [124, 158]], [[82, 160], [110, 160]]]);

/** @param {HTMLCanvasElement} canvas */
function drawStanding(canvas) {
  const pen = canvas.getContext("2d");
  if (pen) {
    pen.strokeStyle = getComputedStyle(canvas).color;
    pen.globalAlpha = 0.35;
    pen.lineWidth = LINE_PX;
    pen.lineCap = pen.lineJoin = "round";
    pen.stroke(new Path2D(STANDING.map((line) => `M${line.map((point) => point.join(" ")).join("L")}`).join("")));
    pen.fillStyle = pen.strokeStyle;
    pen.beginPath();
    pen.arc(96, 40, pixels(HEAD_M), 0, 2 * Math.PI);
    pen.fill();
    pen.globalAlpha = 1;
  }
}

/**
 * @param {HTMLCanvasElement} canvas
 * @param {Clip} clip
 * @param {() => boolean} isSeen
 */
function play(canvas, clip, isSeen) {
  const stroke_s = clip.events.find(({ point }) => point === "stroke")?.timeS ?? clip.durationS / 2;
  canvas.dataset["played"] = "";
  if (matchMedia("(prefers-reduced-motion: reduce)").matches) {
    draw(canvas, clip, stroke_s);
    return;
  }
  let drawn = -1;
  const frame = (/** @type {number} */ now_ms) => {
    const next = Math.floor((now_ms / 1000) * FRAMES_PER_SECOND);
    if (next !== drawn && isSeen()) {
      drawn = next;
      draw(canvas, clip, (next / FRAMES_PER_SECOND) % clip.durationS);
    }
    if (canvas.isConnected) {
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
  pen.fillStyle = pen.strokeStyle;
  pen.lineCap = "round";
  for (const { name, parent } of clip.joints) {
    const [from, to] = [places.get(parent ?? ""), places.get(name)];
    if (from && to && !LEGS.test(name)) {
      pen.lineWidth = FINGERS.test(name) ? LINE_PX / 2 : LINE_PX;
      pen.beginPath();
      pen.moveTo(...from);
      pen.lineTo(...to);
      pen.stroke();
    }
  }
  drawHead(pen, places.get("head"));
}

/**
 * @param {CanvasRenderingContext2D} pen
 * @param {[number, number] | undefined} neck
 */
function drawHead(pen, neck) {
  if (neck) {
    pen.beginPath();
    pen.arc(neck[0], neck[1] - pixels(HEAD_M), pixels(HEAD_M), 0, 2 * Math.PI);
    pen.fill();
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
