/** Takes files that are chosen or dropped: a recording, its words, a body, edits, or a project (kinds.js). */

import { loadEdits } from "../changes/edit_files.js";
import { openedProject } from "../exports/project_file.js";
import { problemOf } from "../service/service.js";
import { ChangeProject } from "../state/change_project.js";
import { AVATAR, PROBLEM } from "../state/performed.js";
import { isRecorded, PROJECT } from "../state/project.js";
import { kindOf, refusalOf } from "./kinds.js";
import { open } from "./opening.js";

/** @import { Store } from "../state/store.js" */

export { TAKEN } from "./kinds.js";

/**
 * Takes files by the endings of their names, and says which it has no use for.
 *
 * @param {Store} store
 * @param {readonly File[]} files
 */
export async function takeFiles(store, files) {
  const of = (/** @type {ReturnType<typeof kindOf>} */ kind) => files.find(({ name }) => kindOf(name) === kind);
  const project = of("project");
  if (project) {
    await openProject(store, project);
    return;
  }
  const [audio, text, body, edits] = [of("audio"), of("text"), of("body"), of("edits")];
  const words = text ? (await text.text()).trim() : undefined;
  if (body) {
    store.set(AVATAR, body);
  }
  takeLine(store, audio, words);
  if (edits) {
    await loadEdits(store, edits);
  }
  const unknown = of(null);
  if (unknown) {
    store.set(PROBLEM, { code: "file_unknown", detail: refusalOf(unknown.name) });
  }
}

/**
 * Opens a recording as a line of its own; that of a line which was only written keeps what was changed in it.
 *
 * @param {Store} store
 * @param {File | undefined} audio
 * @param {string | undefined} words
 */
function takeLine(store, audio, words) {
  if (audio) {
    const known = store.get(PROJECT);
    const isWritten = known.audio !== null && !isRecorded(known.audio);
    const kept = isWritten ? known : { options: known.options, text: known.audio ? "" : known.text };
    open(store, { ...kept, audio, text: words ?? kept.text });
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
    const { project, takes } = await openedProject(file);
    open(store, project, { takes });
  } catch (error) {
    store.set(PROBLEM, problemOf(error));
  }
}

/**
 * Lets files be dropped anywhere on the page; `zone` shows where.
 *
 * @param {Store} store
 * @param {HTMLElement} zone
 */
export function letFilesBeDropped(store, zone) {
  document.addEventListener("dragover", (event) => {
    event.preventDefault();
    zone.classList.add("over");
  });
  document.addEventListener("dragleave", () => zone.classList.remove("over"));
  document.addEventListener("drop", (event) => {
    event.preventDefault();
    zone.classList.remove("over");
    void takeFiles(store, [...(event.dataTransfer?.files ?? [])]);
  });
}
