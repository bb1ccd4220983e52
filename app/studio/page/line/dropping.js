/** Takes files that are chosen or dropped: a recording, its words (.txt), a body (.glb, .vrm), or a project (.zip). */

import { openedProject } from "../exports/project_file.js";
import { problemOf } from "../service/service.js";
import { ChangeProject } from "../state/change_project.js";
import { AVATAR, PROBLEM } from "../state/performed.js";
import { PROJECT } from "../state/project.js";
import { open } from "./opening.js";

/** @import { Store } from "../state/store.js" */

const BODY = /\.(glb|vrm)$/i;
const TEXT = /\.txt$/i;
const PROJECT_FILE = /\.zip$/i;

/**
 * Takes files by the endings of their names; what is neither a body nor a text is taken for a recording, and the service
 * says what is wrong with one that is none.
 *
 * @param {Store} store
 * @param {readonly File[]} files
 */
export async function takeFiles(store, files) {
  const kept = files.find(({ name }) => PROJECT_FILE.test(name));
  if (kept) {
    await openProject(store, kept);
    return;
  }
  const body = files.find(({ name }) => BODY.test(name));
  const text = files.find(({ name }) => TEXT.test(name));
  const audio = files.find(({ name }) => !BODY.test(name) && !TEXT.test(name));
  const words = text ? (await text.text()).trim() : undefined;
  if (body) {
    store.set(AVATAR, body);
  }
  if (audio) {
    const { text: typed, options } = store.get(PROJECT);
    const isFirst = store.get(PROJECT).audio === null;
    open(store, { audio, options, text: words ?? (isFirst ? typed : "") });
  } else if (words !== undefined) {
    store.history.execute(new ChangeProject(store, "Words", { text: words }));
  }
}

/**
 * @param {Store} store
 * @param {File} file
 */
async function openProject(store, file) {
  try {
    open(store, await openedProject(file));
  } catch (error) {
    store.set(PROBLEM, problemOf(error));
  }
}

/**
 * Lets files be dropped anywhere on the page.
 *
 * @param {Store} store
 */
export function letFilesBeDropped(store) {
  document.addEventListener("dragover", (event) => event.preventDefault());
  document.addEventListener("drop", (event) => {
    event.preventDefault();
    void takeFiles(store, [...(event.dataTransfer?.files ?? [])]);
  });
}
