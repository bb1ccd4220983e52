/**
 * Which camera is on when: the scene is shown whole, then whoever speaks, over a listener's shoulder, close, or with whom
 * he speaks to, and now and then who listens; the end is shown whole again.
 */

import { lineAt } from "./sequence.js";

/** @import { SceneLine } from "./scene_index.js" */
/** @import { Span } from "./sequence.js" */

/** @import { Shot } from "../stage/framing.js" */

/** A shot of somebody from a time on; `beside` is whose shoulder is seen. @typedef {Readonly<{ from_s: number, shot: Shot, subject: string, beside: string | null }>} Cut */

const OPENING_S = 2;
const CLOSING_S = 1.5;
const SHORTEST_S = 1.2;
const REACTION_S = 1.6;
const LONG_S = 5;
const REACTION_AT = 0.55;

/** The shots of lines that somebody hears, one after the other. @type {readonly Shot[]} */
const ALTERNATING = Object.freeze(["over_shoulder", "close", "two_shot", "close"]);

/**
 * @param {readonly SceneLine[]} lines
 * @param {readonly Span[]} spans
 * @returns {Cut[]}
 */
export function cutsOf(lines, spans) {
  const [first] = lines;
  const last = spans.at(-1);
  if (!first || !last) {
    return [];
  }
  const whole = { shot: /** @type {Shot} */ ("wide"), subject: first.speaker, beside: null };
  const cuts = lines.flatMap((line, place) => lineCuts(line, spans[place] ?? last, place));
  const spoken = cuts.map((cut, place) => (place === 0 ? { ...cut, from_s: OPENING_S } : cut));
  return spaced([{ ...whole, from_s: 0 }, ...spoken, { ...whole, from_s: last.end_s - CLOSING_S }]);
}

/**
 * The cut that is on at a time.
 *
 * @param {readonly Cut[]} cuts
 * @param {number} time_s
 */
export function cutAt(cuts, time_s) {
  const spans = cuts.map(({ from_s }) => ({ start_s: from_s, end_s: from_s }));
  return cuts[lineAt(spans, time_s)];
}

/**
 * @param {SceneLine} line
 * @param {Span} span
 * @param {number} place
 * @returns {Cut[]}
 */
function lineCuts({ speaker, listeners }, { start_s, end_s }, place) {
  const [listener] = listeners.keys();
  const beside = listener ?? null;
  const shot = listener === undefined ? "close" : (ALTERNATING[place % ALTERNATING.length] ?? "close");
  const main = { from_s: start_s, shot, subject: speaker, beside };
  if (listener === undefined || end_s - start_s < LONG_S) {
    return [main];
  }
  const reaction_s = start_s + REACTION_AT * (end_s - start_s);
  const back = { ...main, from_s: reaction_s + REACTION_S, shot: /** @type {Shot} */ ("close") };
  return [main, { from_s: reaction_s, shot: "close", subject: listener, beside: speaker }, back];
}

/**
 * The cuts without those that the next one follows too soon, or which come too early.
 *
 * @param {readonly Cut[]} cuts
 */
function spaced(cuts) {
  const [opening, ...others] = cuts;
  const kept = others.filter((cut, place) => {
    const next_s = others[place + 1]?.from_s ?? Infinity;
    return cut.from_s >= OPENING_S && next_s - cut.from_s >= SHORTEST_S;
  });
  return opening ? [opening, ...kept] : [];
}
