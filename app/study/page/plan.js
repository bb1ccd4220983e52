/** What a rater sees, and in which order. */

/**
 * @typedef {object} Plan
 * @property {string} name of the study
 * @property {"modes" | "units" | "ways" | "affect" | "speakers"} comparison
 * @property {{ sound: string, body: string, clips: string[] }[]} lines
 * @property {[line: number, clips: number[]][][]} orders of a rater, from the first until they repeat
 * @property {[number, number]} grades the lowest and the highest
 * @property {number} much the preference for the second of a pair where it is much better
 * @property {{ speaker: string, sound: string, body: string, clips: string[] }[]} training each speaker, to be known again
 * @property {string[]} dimensions
 * @property {string} undecided
 * @property {[string, number]} understood what the question is called, and the highest answer
 */

/** The clips of a line, in the order of this rater, by name. @typedef {{ sound: string, body: string, clips: string[] }} Round */

/**
 * The rounds of a rater; of speakers first those with a clip alone, then those with two (NGS §3.5, tests 1 and 2).
 *
 * @param {Plan} plan
 * @param {number} rater from 1
 * @returns {Round[]}
 */
export function roundsOf({ comparison, lines, orders }, rater) {
  const order = orders[(rater - 1) % orders.length] ?? [];
  const rounds = order.flatMap(([line, clips]) => {
    const shown = lines[line];
    return shown ? [{ ...shown, clips: clips.map((place) => shown.clips[place] ?? "") }] : [];
  });
  if (comparison !== "speakers") {
    return rounds;
  }
  const alone = rounds.map((round) => ({ ...round, clips: round.clips.slice(0, 1) }));
  return [...alone, ...rounds];
}

/**
 * The letter by which a rater knows a clip.
 *
 * @param {number} place
 */
export function letter(place) {
  return String.fromCharCode("A".charCodeAt(0) + place);
}
