/** What a dragged movement snaps to: edges of words, strokes of other movements, the playhead. */

/** @import { Performance } from "understudy-client" */
/** @import { Axis } from "./axis.js" */

const NEAR_PX = 5;

/**
 * Times at which something else is.
 *
 * @param {Pick<Performance, "words" | "behaviors">} performance
 * @param {string} id of what is dragged
 * @param {number} playhead_s
 */
export function targetsOf({ words, behaviors }, id, playhead_s) {
  const edges = words.flatMap(({ start_s, end_s }) => [start_s, end_s]);
  const strokes = behaviors.filter((each) => each.kept && each.id !== id).map(({ sync }) => sync["stroke"]);
  return [...edges, ...strokes, playhead_s].filter((time_s) => typeof time_s === "number");
}

/**
 * The nearest of the times, if it is so near that it is meant; null otherwise.
 *
 * @param {number} time_s
 * @param {readonly number[]} targets_s
 * @param {Pick<Axis, "px">} axis
 */
export function snapped(time_s, targets_s, axis) {
  const far_px = (/** @type {number} */ each_s) => Math.abs(axis.px(each_s) - axis.px(time_s));
  const [nearest] = [...targets_s].sort((one, other) => far_px(one) - far_px(other));
  return nearest !== undefined && far_px(nearest) <= NEAR_PX ? nearest : null;
}
