/** Opens lines: the one that `understudy studio` was given, the bundled example, or files that the author chose. */

import { problemOf } from "../service/service.js";
import { PERFORMED, PLAYBACK, PROBLEM, SELECTION } from "../state/performed.js";
import { EMPTY, PROJECT } from "../state/project.js";

/** @import { Service } from "../service/service.js" */
/** @import { Project } from "../state/project.js" */
/** @import { Store } from "../state/store.js" */

/**
 * Begins with a line that nobody changed yet.
 *
 * @param {Store} store
 * @param {Partial<Project>} line
 */
export function open(store, line) {
  store.set(SELECTION, null);
  store.set(PERFORMED, null);
  store.patch(PLAYBACK, { playing: false, loop: null });
  store.set(PROBLEM, null);
  store.history.clear();
  store.set(PROJECT, { ...EMPTY, ...line });
}

/**
 * Opens what the address of the page says: `?line=opened`, `?line=example`, or nothing.
 *
 * @param {Store} store
 * @param {Service} service
 */
export async function openAsAsked(store, service) {
  const asked = new URLSearchParams(location.search).get("line");
  if (asked === "opened") {
    await openWith(store, () => openedLine(service));
  } else if (asked === "example") {
    await openExample(store, service);
  }
}

/**
 * @param {Store} store
 * @param {Service} service
 */
export async function openExample(store, service) {
  await openWith(store, async () => {
    const [audio, text] = await Promise.all([
      service.fetch("studio/example/example.flac").then((answer) => answer.blob()),
      service.fetch("studio/example/example.txt").then((answer) => answer.text()),
    ]);
    return { audio: new File([audio], "example.flac", { type: audio.type }), text: text.trim() };
  });
}

/**
 * @param {Service} service
 * @returns {Promise<Partial<Project>>}
 */
async function openedLine(service) {
  const { name, text } = await (await service.fetch("opened/line")).json();
  const audio = await (await service.fetch("opened/audio")).blob();
  return { audio: new File([audio], name, { type: audio.type }), text };
}

/**
 * @param {Store} store
 * @param {() => Promise<Partial<Project>>} found
 */
async function openWith(store, found) {
  try {
    open(store, await found());
  } catch (error) {
    store.set(PROBLEM, problemOf(error));
  }
}
