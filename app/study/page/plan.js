/** What a rater sees, and in which order. */

/**
 * @typedef {object} Plan
 * @property {string} name of the study
 * @property {"modes" | "units"} comparison
 * @property {{ sound: string, body: string, clips: string[] }[]} lines
 * @property {[line: number, clips: number[]][][]} orders of a rater, from the first until they repeat
 * @property {[number, number]} grades the lowest and the highest
 * @property {string[]} dimensions
 * @property {string} undecided
 * @property {[string, number]} understood what the question is called, and the highest answer
 */

/** The clips of a line, in the order of this rater, by name. @typedef {{ sound: string, body: string, clips: string[] }} Round */

/**
 * @param {Plan} plan
 * @param {number} rater from 1
 * @returns {Round[]}
 */
export function roundsOf({ lines, orders }, rater) {
  const order = orders[(rater - 1) % orders.length] ?? [];
  return order.flatMap(([line, clips]) => {
    const shown = lines[line];
    return shown ? [{ ...shown, clips: clips.map((place) => shown.clips[place] ?? "") }] : [];
  });
}

/**
 * The letter by which a rater knows a clip.
 *
 * @param {number} place
 */
export function letter(place) {
  return String.fromCharCode("A".charCodeAt(0) + place);
}
