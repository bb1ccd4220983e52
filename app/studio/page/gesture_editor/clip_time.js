/** Where a gesture's frames are in the clip that plays it. */

/** @import { Clip, GestureValues } from "understudy-client" */

const STROKES = new Set(["stroke", "stroke_end"]);

/**
 * The time in the clip, seconds, of a time of the gesture (0 to 1): a gesture is faster or slower with agitation and
 * character, and rests before it begins, so the stroke's two ends tell the scale.
 *
 * @param {GestureValues} gesture
 * @param {Clip["events"]} events
 * @param {number} time
 */
export function clipTime({ frames }, events, time) {
  const end = frames.findLast(({ type }) => type === "stroke_end") ?? frames.findLast(({ type }) => STROKES.has(type));
  const first = frames.findIndex(({ type }) => STROKES.has(type));
  const start = frames.find(({ type }) => type === "stroke_start") ?? frames[Math.max(first - 1, 0)];
  const [start_s, end_s] = ["stroke_start", "stroke_end"].map((point) => events.find((each) => each.point === point)?.timeS);
  if (!start || !end || start_s === undefined || end_s === undefined || end.time === start.time) {
    return 0;
  }
  return start_s + ((end_s - start_s) * (time - start.time)) / (end.time - start.time);
}
