/** A batch's `index.json` (docs/batch.md) as a scene: who says what, and which files have it. */

/**
 * A line of the scene. Files are named as in the folder; `listeners` has theirs by name.
 *
 * @typedef {object} SceneLine
 * @property {string} id
 * @property {string} speaker
 * @property {string} performer our character who plays the speaker
 * @property {string} text
 * @property {number} duration_s
 * @property {string} sound
 * @property {string} motion
 * @property {ReadonlyMap<string, string>} listeners
 */

/** @typedef {Record<string, string>} Files by format */
/** @typedef {{ id: string, character: string, performer?: string, text: string, audio: string, duration_s: number | null, files: Files, listeners?: Record<string, Files> }} IndexLine */

const MOTIONS = Object.freeze(["clip.json", "glb"]);
const NOBODY = "speaker";

/**
 * The scene in an index. Throws an Error that says what is missing, and how it is made.
 *
 * @param {{ lines: readonly IndexLine[] }} index
 * @param {ReadonlySet<string>} names of the files that are there
 * @returns {SceneLine[]}
 */
export function sceneOf(index, names) {
  if (!Array.isArray(index.lines) || index.lines.length === 0) {
    throw new Error("index.json has no lines that were performed");
  }
  const lines = index.lines.map((line) => lineOf(line, names));
  const lacking = lines.filter(({ sound, motion }) => !sound || !motion).map(({ id }) => id);
  if (lacking.length > 0) {
    throw new Error(
      `no motion or recording of ${lacking.join(", ")}; perform the batch with --format clip.json --format wav`,
    );
  }
  return lines;
}

/**
 * The files that a scene is read from, as an index names them.
 *
 * @param {{ lines: readonly IndexLine[] }} index
 * @returns {string[]}
 */
export function namesIn({ lines }) {
  const files = lines.flatMap((line) => [line.files, ...Object.values(line.listeners ?? {})]);
  return files.flatMap((forms) => [...MOTIONS, "wav"].flatMap((form) => forms[form] ?? []));
}

/**
 * Everybody in a scene, in the order in which they come in, and our character who plays each.
 *
 * @param {readonly SceneLine[]} lines
 * @returns {Map<string, string>}
 */
export function castOf(lines) {
  const names = new Set(lines.flatMap(({ speaker, listeners }) => [speaker, ...listeners.keys()]));
  const played = new Map(lines.map(({ speaker, performer }) => [speaker, performer]));
  return new Map([...names].map((name) => [name, played.get(name) ?? "default"]));
}

/**
 * @param {IndexLine} line
 * @param {ReadonlySet<string>} names
 * @returns {SceneLine}
 */
function lineOf(line, names) {
  const listeners = Object.entries(line.listeners ?? {});
  const heard = listeners.map(([name, files]) => /** @type {const} */ ([name, motionIn(files, names)]));
  return {
    id: line.id,
    speaker: plainName(line.character),
    performer: line.performer || "default",
    text: line.text,
    duration_s: line.duration_s ?? 0,
    sound: soundOf(line, names),
    motion: motionIn(line.files, names),
    listeners: new Map(heard.filter(([, motion]) => motion !== "")),
  };
}

/**
 * The recording as it was performed, else the file that was performed, if it was dropped as well.
 *
 * @param {IndexLine} line
 * @param {ReadonlySet<string>} names
 */
function soundOf({ audio, files }, names) {
  const own = files["wav"] ?? "";
  const base = audio.split(/[\\/]/).at(-1) ?? "";
  return names.has(own) ? own : ([...names].find((name) => name.split("/").at(-1) === base) ?? "");
}

/**
 * @param {Files} files
 * @param {ReadonlySet<string>} names
 */
function motionIn(files, names) {
  return MOTIONS.map((form) => files[form] ?? "").find((name) => names.has(name)) ?? "";
}

/**
 * A name of the script as listeners are called in a batch.
 *
 * @param {string} name
 */
export function plainName(name) {
  const plain = name.normalize("NFC").replace(/[^\p{L}\p{M}\p{N}]+/gu, "_").replace(/^_+|_+$/g, "").slice(0, 62) || NOBODY;
  return /^\p{L}/u.test(plain) ? plain : `L_${plain}`;
}
