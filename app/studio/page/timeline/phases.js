/** The phases of a gesture between its seven sync points, and the colours that they have everywhere. */

/** @typedef {"preparation" | "hold" | "stroke" | "retraction"} PhaseName */
/** @typedef {Readonly<{ name: PhaseName, from: string, to: string }>} PhaseKind */
/** @typedef {Readonly<{ name: PhaseName, start_s: number, end_s: number }>} Phase */

/** @import { ClipEvent } from "understudy-client" */

/** The seven sync points in their order. */
export const MARKS = Object.freeze(["start", "ready", "stroke_start", "stroke", "stroke_end", "relax", "end"]);

/** @type {readonly PhaseKind[]} */
const KINDS = Object.freeze([
  { name: "preparation", from: "start", to: "ready" },
  { name: "hold", from: "ready", to: "stroke_start" },
  { name: "stroke", from: "stroke_start", to: "stroke_end" },
  { name: "hold", from: "stroke_end", to: "relax" },
  { name: "retraction", from: "relax", to: "end" },
]);

/** @type {Readonly<Record<PhaseName, string>>} */
export const PHASE_COLOURS = Object.freeze({
  preparation: "#3f8fd2",
  stroke: "#d9534f",
  hold: "#8a6fc9",
  retraction: "#2f9e78",
});

/**
 * The phases that last.
 *
 * @param {Readonly<Record<string, number>>} sync
 * @returns {Phase[]}
 */
export function phasesOf(sync) {
  return KINDS.flatMap(({ name, from, to }) => {
    const [start_s, end_s] = [sync[from], sync[to]];
    return start_s !== undefined && end_s !== undefined && end_s > start_s ? [{ name, start_s, end_s }] : [];
  });
}

/**
 * When the sync points of a behaviour are played, which may be other times than were planned; none where it is not.
 *
 * @param {readonly ClipEvent[]} events those of a clip
 * @param {string} id
 * @returns {Record<string, number>}
 */
export function playedSync(events, id) {
  const own = events.filter(({ behavior }) => behavior === id);
  return Object.fromEntries(own.map(({ point, timeS }) => [point, timeS]));
}
