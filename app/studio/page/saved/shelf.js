/** The lines that an author worked on, each as it is now and as it was: kept in this browser, never sent anywhere. */

import { within } from "./database.js";

/** @import { Draft } from "../state/project.js" */
/** @import { Take } from "../takes/takes.js" */

/**
 * A line that is kept.
 *
 * @typedef {object} KeptProject
 * @property {string} id
 * @property {File} audio
 * @property {Draft} draft
 * @property {readonly Take[]} takes
 * @property {number} saved_ms since 1970
 */

/** A line as it was, and what had been done last. @typedef {Readonly<{ id: number, project: string, draft: Draft, label: string, saved_ms: number }>} Version */

const MOST_VERSIONS = 40;
const MOST_PROJECTS = 100;
const APART_MS = 20_000;

/** @param {KeptProject} project */
export async function keep(project) {
  await within("projects", "readwrite", (table) => table.put(project));
  const surplus = (await projects()).slice(MOST_PROJECTS);
  await Promise.all(surplus.map(({ id }) => remove(id)));
}

/**
 * @param {string} id
 * @returns {Promise<KeptProject | undefined>}
 */
export function kept(id) {
  return within("projects", "readonly", (table) => table.get(id));
}

/** All that are kept, the latest first. */
export async function projects() {
  const all = /** @type {KeptProject[]} */ (await within("projects", "readonly", (table) => table.getAll()));
  return all.sort((one, other) => other.saved_ms - one.saved_ms);
}

/**
 * Forgets a line with all its versions.
 *
 * @param {string} id
 */
export async function remove(id) {
  await within("projects", "readwrite", (table) => table.delete(id));
  await forget(await versions(id));
}

/**
 * The versions of a line, the latest first.
 *
 * @param {string} id
 */
export async function versions(id) {
  const all = /** @type {Version[]} */ (await within("versions", "readonly", (table) => table.index("project").getAll(id)));
  return all.sort((one, other) => other.saved_ms - one.saved_ms);
}

/**
 * Keeps how a line is now as a version, unless the last one is of a moment ago.
 *
 * @param {Omit<Version, "id">} version
 */
export async function keepVersion(version) {
  const before = await versions(version.project);
  if (isDue(before[0], version.saved_ms)) {
    await within("versions", "readwrite", (table) => table.add(version));
    await forget(before.slice(MOST_VERSIONS - 1));
  }
}

/**
 * @param {Pick<Version, "saved_ms"> | undefined} last
 * @param {number} now_ms
 */
export function isDue(last, now_ms) {
  return last === undefined || now_ms - last.saved_ms >= APART_MS;
}

/** @param {readonly Version[]} some */
async function forget(some) {
  await Promise.all(some.map(({ id }) => within("versions", "readwrite", (table) => table.delete(id))));
}
