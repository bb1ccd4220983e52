/** A rater's answers: kept in the browser round by round, and written as CSV. */

/** @import { Plan } from "./plan.js" */

/** A row of the file by column. @typedef {Readonly<Record<string, string | number>>} Row */
/** What keeps texts by name, as localStorage does. @typedef {Pick<Storage, "getItem" | "setItem">} Store */

/** The columns of each comparison, in their order. */
const COLUMNS = Object.freeze({
  modes: ["rater", "trial", "position", "clip", "rating", "choice"],
  units: ["rater", "trial", "a", "b", "dimension", "answer"],
  ways: ["rater", "trial", "a", "b", "preference"],
  affect: ["rater", "trial", "a", "b", "preference"],
  speakers: ["rater", "trial", "clip", "beside", "answer"],
});

export class Answers {
  #store;
  #key;
  /** @type {Record<string, Row[]>} */
  #rounds;

  /**
   * Begins with those that this rater has given before, if any.
   *
   * @param {Plan} plan
   * @param {number} rater
   * @param {Store} store
   */
  constructor(plan, rater, store) {
    this.columns = COLUMNS[plan.comparison];
    this.rater = rater;
    this.#store = store;
    this.#key = `study ${plan.name} ${rater}`;
    this.#rounds = JSON.parse(store.getItem(this.#key) ?? "{}");
  }

  /** @param {number} round */
  has(round) {
    return String(round) in this.#rounds;
  }

  /** How many rounds are answered. */
  get count() {
    return Object.keys(this.#rounds).length;
  }

  /**
   * Keeps what was answered in a round.
   *
   * @param {number} round
   * @param {readonly Row[]} rows
   */
  keep(round, rows) {
    const told = rows.map((row) => ({ rater: this.rater, trial: round + 1, ...row }));
    this.#rounds = { ...this.#rounds, [round]: told };
    this.#store.setItem(this.#key, JSON.stringify(this.#rounds));
  }

  /** The file. */
  csv() {
    const rows = Object.values(this.#rounds).flat();
    const lines = rows.map((row) => this.columns.map((name) => cell(row[name] ?? "")).join(","));
    return [this.columns.join(","), ...lines, ""].join("\n");
  }
}

/** @param {string | number} value */
function cell(value) {
  const text = String(value);
  return /[",\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
}
