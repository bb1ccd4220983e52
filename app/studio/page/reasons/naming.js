/** One line of text on a word, function or behaviour, with what it selects. */

/** @import { Behavior, Performance } from "understudy-client" */
/** @import { FoundFunction, Told } from "./telling.js" */

/**
 * @param {Performance} performance
 * @param {number} first
 * @param {number} last
 * @returns {Told}
 */
export function wordsTold({ words }, first, last) {
  return { text: `“${words.slice(first, last + 1).map(({ text }) => text).join(" ")}”`, id: `word:${String(first)}` };
}

/**
 * @param {Performance} performance
 * @param {number} index
 * @returns {Told}
 */
export function wordTold({ words }, index) {
  return { text: `the word “${words[index]?.text ?? ""}”`, id: `word:${String(index)}` };
}

/**
 * @param {string | null | undefined} rule
 * @param {string | null | undefined} fact
 * @returns {Told}
 */
export function ruleTold(rule, fact) {
  return rule ? { text: `${fact ?? ""} by ${rule}`, rule } : { text: fact ?? "" };
}

/**
 * @param {FoundFunction} found
 * @returns {Told}
 */
export function functionTold(found) {
  return { text: `${nameOf(found)} “${found.text}”${found.kept ? "" : " (dropped)"}`, id: found.id };
}

/**
 * @param {Behavior} behavior
 * @returns {Told}
 */
export function behaviorTold({ id, kind, lexeme, kept }) {
  return { text: `${kind} ${lexeme}${kept ? "" : " (dropped)"}`, id };
}

/**
 * @param {{ lost_to?: string | null | undefined, reason?: string | null | undefined }} dropped
 * @returns {Told}
 */
export function lostTold({ lost_to: lostTo, reason }) {
  const text = reason ?? `gave way to ${lostTo ?? "nothing"}`;
  return lostTo ? { text, id: lostTo } : { text };
}

/** @param {FoundFunction} found */
export function nameOf(found) {
  return [found.class, found.subtype].filter(Boolean).join(".");
}

/** @param {number | undefined} time_s */
export function seconds(time_s) {
  return time_s === undefined ? "not spoken" : `${time_s.toFixed(3)} s`;
}

/** @param {number} weight */
export function signed(weight) {
  return `${weight < 0 ? "−" : "+"}${Math.abs(weight).toFixed(2)}`;
}
