/** A project as one file to keep: a zip of the recording, its words, the options, what was changed by hand, and the takes. */

import { strFromU8, strToU8, zipSync } from "fflate";

import { EMPTY } from "../state/project.js";
import { unzipped } from "./zip_files.js";

/** @import { Line } from "../service/performing.js" */
/** @import { Project } from "../state/project.js" */
/** @import { Take } from "../takes/takes.js" */

const AUDIO = "audio/";
const TEXT = "text.txt";
const TAKES = "takes.json";
const PARTS = /** @type {const} */ (["options", "direction", "words", "edits"]);

/**
 * The zip. Parts that there are none of are left out.
 *
 * @param {Line} line
 * @param {readonly Take[]} takes
 */
export async function projectFile(line, takes) {
  const parts = PARTS.flatMap((name) => (line[name] === null ? [] : [[`${name}.json`, strToU8(JSON.stringify(line[name], null, 2))]]));
  const audio = new Uint8Array(await line.audio.arrayBuffer());
  const files = { [AUDIO + line.audio.name]: audio, [TEXT]: strToU8(line.text), ...Object.fromEntries(parts) };
  const kept = takes.length > 0 ? { [TAKES]: strToU8(JSON.stringify(takes, null, 2)) } : {};
  return new Blob([owned(zipSync({ ...files, ...kept }, { level: 6 }))], { type: "application/zip" });
}

/**
 * What is in a project's file. Rejects where it is none.
 *
 * @param {File} file
 * @returns {Promise<{ project: Project, takes: readonly Take[] }>}
 */
export async function openedProject(file) {
  const files = unzipped(file.name, new Uint8Array(await file.arrayBuffer()));
  const [path, audio] = Object.entries(files).find(([name]) => name.startsWith(AUDIO)) ?? [];
  const text = files[TEXT];
  if (!path || !audio || !text) {
    throw new Error(`${file.name} is not a project of the studio: it has no ${audio ? TEXT : `recording below ${AUDIO}`}`);
  }
  const parts = PARTS.map((name) => [name, partOf(file.name, `${name}.json`, files) ?? EMPTY[name]]);
  const recording = new File([owned(audio)], path.slice(AUDIO.length));
  const project = { ...EMPTY, ...Object.fromEntries(parts), audio: recording, text: strFromU8(text) };
  return { project, takes: /** @type {readonly Take[]} */ (partOf(file.name, TAKES, files) ?? []) };
}

/**
 * @param {string} name
 * @param {string} part
 * @param {Record<string, Uint8Array>} files
 * @returns {unknown}
 */
function partOf(name, part, files) {
  const content = files[part];
  if (!content) {
    return undefined;
  }
  try {
    return JSON.parse(strFromU8(content));
  } catch (error) {
    throw new Error(`${name}: ${part} is not JSON: ${error instanceof Error ? error.message : ""}`, { cause: error });
  }
}

/**
 * The same bytes in a buffer of their own.
 *
 * @param {Uint8Array} bytes
 * @returns {Uint8Array<ArrayBuffer>}
 */
function owned(bytes) {
  return new Uint8Array(bytes);
}
