/** What the service made of the project, what is looked at, and what went wrong. */

import { slice } from "./slice.js";

/** @import { Clip, Performance, Performed } from "understudy-client" */

/**
 * A line as it was performed: the service's answer, its parts by the names that all use, and the motion.
 *
 * @typedef {object} PerformedLine
 * @property {Performed} answer
 * @property {Performance} performance
 * @property {string} bml
 * @property {Clip} motion
 * @property {ReadonlyMap<string, Clip>} listeners motions by the listeners' names
 * @property {Contours | null} contours f0 and energy
 * @property {object | null} edits those that it was made with
 */

/** @typedef {NonNullable<Performed["contours"]>} Contours */

/** Null until a line was performed, and then the last one that could be. */
export const PERFORMED = slice(/** @type {PerformedLine | null} */ (null));

/** Whether a performance is being made. */
export const BUSY = slice(false);

/**
 * The id of the function or behaviour that is looked at, `word:3` for a word, null for none.
 */
export const SELECTION = slice(/** @type {string | null} */ (null));

/**
 * What was refused and why, in the words of whoever refused; `code` is the service's. Null where nothing was.
 *
 * @typedef {Readonly<{ code: string, detail: string, field?: string | undefined }>} Problem
 */
export const PROBLEM = slice(/** @type {Problem | null} */ (null));

/**
 * How the line is played. `loop` is the stretch that is played again and again, in seconds of the performance.
 *
 * @typedef {object} Playback
 * @property {boolean} playing
 * @property {number} speed
 * @property {readonly [number, number] | null} loop
 */
export const PLAYBACK = slice(/** @type {Readonly<Playback>} */ (Object.freeze({ playing: false, speed: 1, loop: null })));

/** Where the playhead is, in seconds of the performance (whose recording starts at `lead_in_s`); set in each frame. */
export const TIME_S = slice(0);

/** The body that the author dropped in place of ours, a GLB or VRM file; null for ours. */
export const AVATAR = slice(/** @type {File | null} */ (null));
