/**
 * A line as its author has it: the recording, its words, how it is to be performed, and what was changed by hand. All
 * that a performance depends on is here, so whoever changes the project gets another performance and another motion
 * (`service/performing.js`).
 */

import { slice } from "./slice.js";

/** @import { Direction, PerformOptions } from "understudy-client" */

/**
 * `options` are those of `POST /perform`, `words` the times of words that the author corrected (as `understudy align`
 * writes them), `edits` what was changed by hand (as `perform --edits` reads it), `rules` the texts of edited files of
 * rules and words by their names; null where there are none.
 *
 * @typedef {object} Project
 * @property {File | null} audio null before a line is open; an empty file where it is not recorded yet
 * @property {string} text
 * @property {PerformOptions} options
 * @property {Direction | null} direction
 * @property {object | null} words
 * @property {object | null} edits
 * @property {Readonly<Record<string, string>> | null} rules
 */

/** A line that nothing is known of. @type {Readonly<Project>} */
export const EMPTY = Object.freeze({
  audio: null,
  text: "",
  options: Object.freeze({}),
  direction: null,
  words: null,
  edits: null,
  rules: null,
});

export const PROJECT = slice(EMPTY);

/**
 * What stands for the recording of a line that is only written: an empty file of that name.
 *
 * @param {string} text
 */
export function unrecorded(text) {
  return new File([], text.trim().split(/\s+/).slice(0, 4).join(" ") || "Unrecorded line");
}

/**
 * What a line is called: its recording, or its first words with dots where there are more.
 *
 * @param {File} audio
 * @param {string} text
 */
export function titleOf(audio, text) {
  const isCut = !isRecorded(audio) && text.trim().split(/\s+/).length > audio.name.split(" ").length;
  return isCut ? `${audio.name}…` : audio.name;
}

/** @param {File} audio */
export function isRecorded(audio) {
  return audio.size > 0;
}

/** What of a project changes while it is worked on. @typedef {Omit<Project, "audio">} Draft */

/**
 * @param {Readonly<Project>} project
 * @returns {Draft}
 */
export function draftOf({ text, options, direction, words, edits, rules }) {
  return { text, options, direction, words, edits, rules };
}

/**
 * By what the line is known among those that are kept, and how it was opened where it is found so again.
 *
 * @typedef {Readonly<{ id: string, kept: Readonly<{ project: Readonly<Project>, takes: readonly object[] }> | null }>} Opened
 */
export const OPENED = slice(/** @type {Opened} */ ({ id: "", kept: null }));
