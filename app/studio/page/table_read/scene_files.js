/** The files of a batch's folder, dropped, chosen or packed in a zip, by their paths from where `index.json` lies. */

import { unzipped } from "../exports/zip_files.js";
import { namesIn } from "./scene_index.js";

/** @import { Service } from "../service/service.js" */

/** @typedef {ReadonlyMap<string, Blob>} SceneFiles */

const INDEX = "index.json";
const ZIP = /\.zip$/i;

/**
 * Rejects where there is no index.
 *
 * @param {readonly File[]} files chosen from a folder, or one zip
 * @returns {Promise<SceneFiles>}
 */
export async function sceneFiles(files) {
  const [only] = files;
  if (only && files.length === 1 && ZIP.test(only.name)) {
    return fromIndex(await unpacked(only));
  }
  return fromIndex(new Map(files.map((file) => [file.webkitRelativePath || file.name, file])));
}

/**
 * The files of the scene with which `understudy studio --scene` opened the page.
 *
 * @param {Service} service
 * @returns {Promise<SceneFiles>}
 */
export async function openedFiles(service) {
  const file = async (/** @type {string} */ name) => (await service.fetch(`opened/scene/${name}`)).blob();
  const index = await file(INDEX);
  const names = namesIn(JSON.parse(await index.text()));
  const found = names.map(async (name) => /** @type {const} */ ([name, await file(encodeURI(name))]));
  return new Map([[INDEX, index], ...(await Promise.all(found))]);
}

/**
 * The files that were dropped, those in folders too.
 *
 * @param {DataTransfer} dropped
 * @returns {Promise<SceneFiles>}
 */
export async function droppedFiles(dropped) {
  const entries = [...dropped.items].map((item) => item.webkitGetAsEntry());
  const [only] = dropped.files;
  if (only && dropped.files.length === 1 && ZIP.test(only.name)) {
    return fromIndex(await unpacked(only));
  }
  const found = await Promise.all(entries.flatMap((entry) => (entry ? [filesIn(entry)] : [])));
  return fromIndex(new Map(found.flat()));
}

/** @param {File} file */
async function unpacked(file) {
  const packed = unzipped(file.name, new Uint8Array(await file.arrayBuffer()));
  return new Map(Object.entries(packed).map(([path, bytes]) => [path, new Blob([bytes.slice().buffer])]));
}

/**
 * @param {ReadonlyMap<string, Blob>} files
 * @returns {SceneFiles}
 */
function fromIndex(files) {
  const places = [...files.keys()].filter((path) => path.split("/").at(-1) === INDEX);
  const [index] = places.sort((one, other) => one.length - other.length);
  if (index === undefined) {
    throw new Error("there is no index.json; take the folder that understudy batch wrote to (--out)");
  }
  const folder = index.slice(0, -INDEX.length);
  const inside = [...files].filter(([path]) => path.startsWith(folder));
  return new Map(inside.map(([path, file]) => [path.slice(folder.length), file]));
}

/**
 * @param {FileSystemEntry} entry
 * @returns {Promise<[string, File][]>}
 */
async function filesIn(entry) {
  if (entry instanceof FileSystemFileEntry) {
    const file = await new Promise((/** @type {(file: File) => void} */ resolve, reject) => entry.file(resolve, reject));
    return [[entry.fullPath.slice(1), file]];
  }
  if (!(entry instanceof FileSystemDirectoryEntry)) {
    return [];
  }
  const inside = await entriesIn(entry.createReader());
  return (await Promise.all(inside.map(filesIn))).flat();
}

/**
 * A reader gives a hundred entries at a time.
 *
 * @param {FileSystemDirectoryReader} reader
 * @returns {Promise<FileSystemEntry[]>}
 */
async function entriesIn(reader) {
  /** @type {FileSystemEntry[]} */
  const some = await new Promise((resolve, reject) => reader.readEntries(resolve, reject));
  return some.length === 0 ? [] : [...some, ...(await entriesIn(reader))];
}
