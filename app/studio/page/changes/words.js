/** What an author does to a word: marks it, or corrects when it is spoken. */

import { heardWords } from "../service/performing.js";
import { PERFORMED } from "../state/performed.js";
import { changeEdits, editsOf } from "./change_edits.js";
import { withWord } from "./edits.js";

/** @import { Edits, Performance, WordEdit } from "understudy-client" */
/** @import { WordChange } from "./edits.js" */
/** @import { Store } from "../state/store.js" */

const ID = /^word:(\d+)$/;
const SHORTEST_S = 0.02;

/**
 * The number of the word that an id of the timeline means; null for anything else.
 *
 * @param {string | null} id
 */
export function wordOf(id) {
  const found = ID.exec(id ?? "");
  return found ? Number(found[1]) : null;
}

/**
 * The edit of a word, if there is one.
 *
 * @param {Store} store
 * @param {number} index
 * @returns {WordEdit | null}
 */
export function wordEditOf(store, index) {
  return editsOf(store).words?.find(({ at }) => at.word === index) ?? null;
}

/**
 * @param {Store} store
 * @param {number} index
 * @param {WordEdit["mark"]} mark
 */
export function markWord(store, index, mark) {
  changeWord(store, "Mark", index, { mark: mark ?? undefined });
}

/**
 * Has a word spoken from one time to another, seconds of the performance.
 *
 * @param {Store} store
 * @param {number} index
 * @param {number} start_s
 * @param {number} end_s
 */
export function timeWord(store, index, start_s, end_s) {
  const performance = store.get(PERFORMED)?.performance;
  if (performance) {
    changeWord(store, "Time", index, timed(store, performance, index, [start_s, end_s]));
  }
}

/**
 * Has a word spoken so much later, counted from where it was put last, be it performed so already or not.
 *
 * @param {Store} store
 * @param {number} index
 * @param {number} later_s
 */
export function moveWord(store, index, later_s) {
  const performance = store.get(PERFORMED)?.performance;
  const [lead_in_s, put] = [performance?.lead_in_s ?? 0, wordEditOf(store, index)];
  const told = isTimed(put) ? { start_s: put.start_s + lead_in_s, end_s: put.end_s + lead_in_s } : performance?.words[index];
  if (isTimed(told)) {
    timeWord(store, index, told.start_s + later_s, told.end_s + later_s);
  }
}

/**
 * @param {{ start_s?: number | null, end_s?: number | null } | null | undefined} word
 * @returns {word is { start_s: number, end_s: number }}
 */
function isTimed(word) {
  return typeof word?.start_s === "number" && typeof word.end_s === "number";
}

/**
 * The edits with a word, or the edge of it that is called so, spoken so much later.
 *
 * @param {Store} store
 * @param {Edits} now
 * @param {Performance} performance
 * @param {number} index
 * @param {{ mark: string | null, later_s: number }} moved
 */
export function withWordMoved(store, now, performance, index, { mark, later_s }) {
  const word = performance.words[index];
  if (!isTimed(word)) {
    return now;
  }
  const { start_s, end_s } = word;
  const start = mark === "end" ? start_s : Math.min(start_s + later_s, mark === "start" ? end_s - SHORTEST_S : Infinity);
  const end = mark === "start" ? end_s : Math.max(end_s + later_s, mark === "end" ? start_s + SHORTEST_S : -Infinity);
  return withWord(now, performance, index, timed(store, performance, index, [start, end]));
}

/**
 * Times of the recording, and when the word was heard in it.
 *
 * @param {Store} store
 * @param {Performance} performance
 * @param {number} index
 * @param {readonly [number, number]} spoken_s
 * @returns {WordChange}
 */
function timed(store, performance, index, spoken_s) {
  const [start_s, end_s] = spoken_s.map((time_s) => Math.max(0, Math.round(1000 * (time_s - performance.lead_in_s)) / 1000));
  const heard = heardWords(store)?.[index];
  return { start_s, end_s, heard: isTimed(heard) ? { start_s: heard.start_s, end_s: heard.end_s } : undefined };
}

/**
 * @param {Store} store
 * @param {string} label
 * @param {number} index
 * @param {WordChange} change
 */
function changeWord(store, label, index, change) {
  const performance = store.get(PERFORMED)?.performance;
  if (performance) {
    const text = performance.words[index]?.text ?? "";
    changeEdits(store, `${label} “${text}”`, withWord(editsOf(store), performance, index, change));
  }
}
