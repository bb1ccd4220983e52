/** How the stage is looked at, and who stands on it: `ROLES` says it, and the stage has them stand there. */

import { slice } from "../state/slice.js";
import { OPPOSITE_M } from "./cameras.js";

/** @import { PerformedLine } from "../state/performed.js" */
/** @import { Shot } from "./cameras.js" */
/** @import { Role } from "./figure.js" */
/** @import { Size } from "./picturing.js" */
/** @import { Vector } from "understudy-client" */

/** Where a listener is seen: not at all, opposite the speaker, or alone. @typedef {"none" | "beside" | "instead"} Listening */

/**
 * `trail` shows the path of the wrists, `onion` the body at the strokes around the playhead, `safe` how much of the picture
 * every screen shows.
 *
 * @typedef {Readonly<{ shot: Shot, listening: Listening, trail: boolean, onion: boolean, safe: boolean }>} Viewing
 */

export const VIEWING = slice(/** @type {Viewing} */ ({ shot: "medium", listening: "none", trail: false, onion: false, safe: false }));

/**
 * Others on the stage beside the line's own, as a second version to compare: whoever compares sets this.
 */
export const GUESTS = slice(/** @type {readonly Role[]} */ ([]));

/** What the first of them is called. */
export const COMPARED_NAME = slice("");

/**
 * What the stage is shown and heard on, for those who take pictures: `draw` draws it as it is now.
 *
 * `fix` has pictures of a size; null: as large as the stage is.
 *
 * @typedef {Readonly<{ canvas: HTMLCanvasElement, audio: HTMLAudioElement, draw: () => void, fix: (size: Size | null) => void }>} Screen
 */

/** Null before there is a stage. */
export const SCREEN = slice(/** @type {Screen | null} */ (null));

/** Whom the page has listen: a character. */
export const LISTENER = "reserved";

/** The names of the characters; none before they are known. */
export const CHARACTERS = slice(/** @type {readonly string[]} */ ([]));

/**
 * Who stands on the stage for a line.
 *
 * @param {PerformedLine} line
 * @param {Listening} listening
 * @param {File | null} avatar
 * @param {readonly string[]} characters a listener who is none of them has the usual body
 * @returns {Role[]}
 */
export function rolesOf({ performance, motion, listeners }, listening, avatar, characters) {
  const { character } = performance;
  /** @type {Vector} */
  const origin = [0, 0, 0];
  const speaker = { name: "speaker", character, motion, place_m: origin, turn_rad: 0, avatar };
  const heard = [...listeners].map(([name, clip]) => {
    const place_m = listening === "instead" ? origin : standing(performance.targets?.[name]);
    const turn_rad = listening === "instead" ? 0 : Math.atan2(-place_m[0], -place_m[2]);
    return { name, character: characters.includes(name) ? name : "default", motion: clip, place_m, turn_rad, avatar: null };
  });
  return listening === "none" ? [speaker] : listening === "instead" ? heard : [speaker, ...heard];
}

/**
 * Whether a version that is compared is seen: shots on a listener have no room beside the speaker, and would cut it.
 *
 * @param {Viewing} viewing
 */
export function showsGuests({ shot, listening }) {
  return shot !== "over_shoulder" && !(shot === "two_shot" && listening === "beside");
}

/**
 * Where somebody stands whose head is there.
 *
 * @param {readonly number[] | undefined} head_m
 * @returns {Vector}
 */
function standing(head_m) {
  return head_m ? [head_m[0] ?? 0, 0, head_m[2] ?? 0] : OPPOSITE_M;
}
