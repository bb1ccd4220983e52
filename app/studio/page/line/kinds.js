/** What a file is to a line, by the ending of its name. */

/** @typedef {"audio" | "text" | "body" | "project" | "edits"} Kind */

const ENDINGS = Object.freeze({
  audio: ["wav", "flac", "ogg", "oga", "opus", "mp3", "m4a", "aac", "aif", "aiff", "webm"],
  text: ["txt"],
  body: ["glb", "vrm"],
  project: ["zip"],
  edits: ["json"],
});

/** Where other files belong. */
const ELSEWHERE = Object.freeze({
  gesture: "gestures are opened in the gesture editor",
  rules: "rules and word lists are edited under Rules",
  yaml: "rules and word lists are edited under Rules",
  csv: "a script is performed by understudy batch, whose folder opens under Table read",
  bml: "BML is played by understudy realize",
});

/** What a file field takes. */
export const TAKEN = Object.values(ENDINGS).flatMap((endings) => endings.map((ending) => `.${ending}`)).join(",");

/**
 * @param {string} name
 * @returns {Kind | null} null for what a line has no use for
 */
export function kindOf(name) {
  const found = Object.entries(ENDINGS).find(([, endings]) => endings.includes(endingOf(name)));
  return /** @type {Kind | null} */ (found?.[0] ?? null);
}

/**
 * What is said of a file that a line has no use for.
 *
 * @param {string} name
 */
export function refusalOf(name) {
  const place = /** @type {Readonly<Record<string, string>>} */ (ELSEWHERE)[endingOf(name)];
  const known = "a line is made of a recording (WAV, FLAC, OGG), its words (.txt), a body (.glb, .vrm), edits (.json) or a project (.zip)";
  return `${name}: ${place ?? `this kind of file is not known; ${known}`}`;
}

/** @param {string} name */
function endingOf(name) {
  return name.toLowerCase().split(".").at(-1) ?? "";
}
