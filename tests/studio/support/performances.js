/** Performances made by hand, for tests. */

/** @import { Behavior, Performance } from "understudy-client" */

const MARKS = ["start", "ready", "stroke_start", "stroke", "stroke_end", "relax", "end"];

/**
 * A behaviour whose marks are a tenth of a second apart.
 *
 * @param {Partial<Behavior> & { id: string, start_s?: number }} given
 * @returns {Behavior}
 */
export function behavior({ start_s = 0, ...given }) {
  const sync = Object.fromEntries(MARKS.map((mark, index) => [mark, start_s + index / 10]));
  return { kind: "gesture", lexeme: "NEGATION", first: 0, last: 0, priority: 5, kept: true, sync, ...given };
}

/**
 * A line of two words of half a second each.
 *
 * @param {Partial<Performance>} given
 * @returns {Performance}
 */
export function performance(given = {}) {
  return {
    audio: { duration_s: 1 },
    words: ["No,", "never"].map((text, index) => ({ index, text, start_s: index / 2, end_s: (index + 1) / 2, phones: [] })),
    fillers: [],
    stress: { energy_db: 0 },
    agitation: "low",
    memberships: { low: 1, medium: 0, high: 0 },
    parse: { tokens: [], phrases: [], clauses: [] },
    functions: [],
    warnings: [],
    character: "default",
    seed: 0,
    lead_in_s: 0,
    stillness: 0,
    moments: [],
    behaviors: [],
    visemes: [],
    focus: [],
    ...given,
  };
}

/**
 * @param {Partial<Performance["functions"][number]> & { id: string }} given
 * @returns {Performance["functions"][number]}
 */
export function foundFunction(given) {
  const words = { first: 0, last: 0, text: "No,", start_s: 0, end_s: 0.5 };
  return { class: "negation", subtype: "", ...words, priority: 5, rule: "negation_word", because: [{ word: 0 }], kept: true, ...given };
}
