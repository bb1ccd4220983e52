/** The stretch of time that the timeline shows, and how it is zoomed and scrolled. */

import { slice } from "../state/slice.js";

/** @typedef {Readonly<{ start_s: number, length_s: number }>} Stretch */

const SHORTEST_S = 0.25;

/** What is shown; null for the whole line. */
export const STRETCH = slice(/** @type {Stretch | null} */ (null));

/**
 * A stretch of a line of `whole_s`: no longer than it, no shorter than can be looked at, and within it.
 *
 * @param {Stretch} wanted
 * @param {number} whole_s
 * @returns {Stretch}
 */
export function within(wanted, whole_s) {
  const length_s = Math.min(whole_s, Math.max(SHORTEST_S, wanted.length_s));
  return { length_s, start_s: Math.min(whole_s - length_s, Math.max(0, wanted.start_s)) };
}

/**
 * `factor` times as much as before, with `still_s` in its place.
 *
 * @param {Stretch} stretch
 * @param {number} factor
 * @param {number} still_s
 * @param {number} whole_s
 */
export function zoomed(stretch, factor, still_s, whole_s) {
  const length_s = Math.min(whole_s, Math.max(SHORTEST_S, stretch.length_s * factor));
  const share = (still_s - stretch.start_s) / stretch.length_s;
  return within({ length_s, start_s: still_s - share * length_s }, whole_s);
}

/**
 * @param {Stretch} stretch
 * @param {number} by_s
 * @param {number} whole_s
 */
export function scrolled(stretch, by_s, whole_s) {
  return within({ ...stretch, start_s: stretch.start_s + by_s }, whole_s);
}

/** Seconds and pixels of a stretch that is drawn from `left_px` on, `width_px` wide. */
export class Axis {
  /**
   * @param {Stretch} stretch
   * @param {number} left_px
   * @param {number} width_px
   */
  constructor(stretch, left_px, width_px) {
    this.stretch = stretch;
    this.left_px = left_px;
    this.width_px = width_px;
  }

  /** @param {number} time_s */
  px(time_s) {
    return this.left_px + ((time_s - this.stretch.start_s) / this.stretch.length_s) * this.width_px;
  }

  /** @param {number} px */
  time_s(px) {
    return this.stretch.start_s + ((px - this.left_px) / this.width_px) * this.stretch.length_s;
  }
}
