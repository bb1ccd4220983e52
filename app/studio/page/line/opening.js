/** Opens lines: the one that `understudy studio` was given, the bundled example, one that is kept, or files that the author chose. */

import { problemOf } from "../service/service.js";
import { PERFORMED, PLAYBACK, PROBLEM, SELECTION } from "../state/performed.js";
import { EMPTY, OPENED, PROJECT } from "../state/project.js";
import { lineBefore } from "../saved/autosave.js";
import { STARTING } from "./starting.js";
import { TAKES } from "../takes/takes.js";

/** @import { Service } from "../service/service.js" */
/** @import { Project } from "../state/project.js" */
/** @import { Store } from "../state/store.js" */
/** @import { KeptProject } from "../saved/shelf.js" */
/** @import { Take } from "../takes/takes.js" */

/**
 * Begins with a line. It is kept at once, unless it is found again as it is: then with its first change.
 *
 * @param {Store} store
 * @param {Partial<Project>} line
 * @param {{ takes?: readonly Take[], id?: string, isFound?: boolean }} [known] its takes; by what it is kept, if it was
 *   before; whether it is found again as it is
 */
export function open(store, line, { takes = [], id = newId(), isFound = false } = {}) {
  const project = { ...EMPTY, ...line };
  store.set(SELECTION, null);
  store.set(PERFORMED, null);
  store.patch(PLAYBACK, { playing: false, loop: null });
  store.set(PROBLEM, null);
  store.history.clear();
  store.set(STARTING, false);
  store.set(OPENED, { id, kept: isFound ? { project, takes } : null });
  store.set(TAKES, takes);
  store.set(PROJECT, project);
}

/**
 * Goes on with a line that was kept.
 *
 * @param {Store} store
 * @param {KeptProject} project
 */
export function openKept(store, { id, audio, draft, takes }) {
  open(store, { ...draft, audio }, { takes, id, isFound: true });
}

/** Also where the page is not from a secure place, in which browsers make none by themselves. */
function newId() {
  return `${String(Date.now())}-${Math.random().toString(36).slice(2)}`;
}

/**
 * Opens what was open before the page was loaded again, else what its address says: `?line=opened`, `?line=example`, or
 * nothing.
 *
 * @param {Store} store
 * @param {Service} service
 */
export async function openAsAsked(store, service) {
  const before = await lineBefore();
  const asked = new URLSearchParams(location.search).get("line");
  if (before) {
    openKept(store, before);
  } else if (asked === "opened") {
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
    open(store, await found(), { isFound: true });
  } catch (error) {
    store.set(PROBLEM, problemOf(error));
  }
}
