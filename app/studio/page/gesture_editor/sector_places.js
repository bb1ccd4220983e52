/** Where the sectors of gesture space are on the picture of the body, as seen by whoever stands before it. */

/** @import { GestureLanguage } from "understudy-client" */

/** A stretch of the picture, shares of it from its left or top. @typedef {Readonly<{ name: string, from: number, to: number }>} Stretch */

/** @type {Readonly<Record<string, string>>} */
const NAMES = Object.freeze({
  XEP: "farthest out", XP: "far out", XC: "out", XCC: "in the middle", XOppC: "across", XOppP: "far across", XOppEP: "farthest across",
  YUpperEP: "Highest", YUpperP: "High", YUpperC: "Rather high", YCC: "At the centre", YLowerC: "Rather low", YLowerP: "Low", YLowerEP: "Lowest",
});

/**
 * What people call a sector.
 *
 * @param {Readonly<{ x: string, y: string }>} place
 */
export function sectorName({ x, y }) {
  return `${NAMES[y] ?? y}, ${NAMES[x] ?? x}`;
}

/**
 * The columns of the picture, the outermost sector of the hand's own side first for the right hand, last for the left.
 *
 * @param {GestureLanguage} language
 * @param {"left" | "right"} side
 */
export function columns({ x }, side) {
  const outwards = x.map(({ name, place_m }) => ({ name, at: side === "right" ? -place_m : place_m }));
  return stretches(outwards);
}

/** @param {GestureLanguage} language */
export function rows({ y }) {
  return stretches(y.map(({ name, place_m }) => ({ name, at: -place_m })));
}

/**
 * Stretches around places, whose borders are midway between them; the outer ones are as wide outwards as inwards.
 *
 * @param {readonly Readonly<{ name: string, at: number }>[]} places
 * @returns {Stretch[]}
 */
function stretches(places) {
  const sorted = [...places].sort((one, other) => one.at - other.at);
  const at = sorted.map((each) => each.at);
  const inner = at.slice(1).map((each, index) => (each + (at[index] ?? 0)) / 2);
  const [first, last] = [at[0] ?? 0, at.at(-1) ?? 0];
  const borders = [2 * first - (inner[0] ?? first), ...inner, 2 * last - (inner.at(-1) ?? last)];
  const [begin, end] = [borders[0] ?? 0, borders.at(-1) ?? 1];
  const share = (/** @type {number | undefined} */ border) => ((border ?? 0) - begin) / (end - begin);
  return sorted.map(({ name }, index) => ({ name, from: share(borders[index]), to: share(borders[index + 1]) }));
}
