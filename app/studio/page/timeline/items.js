/** Items of the timeline from what has times. */

/** @import { Loose } from "./tracks.js" */

/**
 * An item that has a time, else none.
 *
 * @param {string} id
 * @param {string} label
 * @param {number | null | undefined} start_s
 * @param {number | null | undefined} end_s
 * @returns {Loose[]}
 */
export function within(id, label, start_s, end_s) {
  const isTimed = typeof start_s === "number" && typeof end_s === "number";
  return isTimed ? [{ id, label, technical: label, start_s, end_s, kept: true, marks: [], phases: [], why: "" }] : [];
}
