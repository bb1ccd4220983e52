/** What two performances of a line have in common, and what each has for itself. */

/** @import { Behavior } from "understudy-client" */
/** @import { PerformedLine } from "../state/performed.js" */

/** @typedef {Readonly<{ same: number, here: readonly Behavior[], there: readonly Behavior[] }>} Differences */

/**
 * @param {Pick<PerformedLine, "performance">} line
 * @param {Pick<PerformedLine, "performance">} other
 * @returns {Differences}
 */
export function differences(line, other) {
  const [own, others] = [line, other].map(({ performance }) => performance.behaviors.filter(({ kept }) => kept));
  const [ownSaid, othersSaid] = [own, others].map((behaviors) => new Set((behaviors ?? []).map(said)));
  const here = (own ?? []).filter((each) => !othersSaid?.has(said(each)));
  const there = (others ?? []).filter((each) => !ownSaid?.has(said(each)));
  return { same: (own?.length ?? 0) - here.length, here, there };
}

/** @param {Differences} found */
export function toldDifferences({ same, here, there }) {
  return `${String(same)} movements are the same; ${String(here.length)} only here, ${String(there.length)} only there.`;
}

/** @param {Behavior} behavior */
function said({ kind, lexeme, hand, sync }) {
  return JSON.stringify([kind, lexeme, hand, sync]);
}
