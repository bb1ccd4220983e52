/** Edits as a file: what `perform --edits` reads, with the options of the line that are not the usual ones. */

import { el, fileButton } from "../dom.js";
import { problemOf } from "../service/service.js";
import { PROBLEM } from "../state/performed.js";
import { PROJECT } from "../state/project.js";
import { ChangeProject } from "../state/change_project.js";

/** @import { Edits, PerformOptions } from "understudy-client" */
/** @import { Project } from "../state/project.js" */
/** @import { Store } from "../state/store.js" */

const SETTINGS = /** @type {const} */ (["character", "agitation", "seed", "stillness", "mode", "affect"]);

/**
 * The edits of a line as `perform --edits` makes the same of the same recording and words.
 *
 * @param {Project} project
 * @returns {Edits}
 */
export function editsFile({ options, edits }) {
  const told = SETTINGS.flatMap((name) => (options[name] === undefined || options[name] === null ? [] : [[name, options[name]]]));
  return { version: 1, line: Object.fromEntries(told), .../** @type {Edits | null} */ (edits) };
}

/**
 * The keys of a project that a file of edits sets: what it says of the line becomes options again.
 *
 * @param {Project} project
 * @param {Edits} file
 */
export function projectWith({ options }, { line = {}, ...edits }) {
  const told = Object.entries(line ?? {}).filter(([, value]) => value !== null);
  return { options: /** @type {PerformOptions} */ ({ ...options, ...Object.fromEntries(told) }), edits };
}

/** @param {Store} store */
export function fileButtons(store) {
  const load = (/** @type {File[]} */ [file]) => file && void loadEdits(store, file);
  const chosen = fileButton("Load edits…", { id: "edits-file", accept: ".json" }, load);
  const save = el("button", { type: "button", id: "save-edits", click: () => download(store) }, ["Save edits"]);
  return el("div", { class: "row", role: "group", "aria-label": "File of edits" }, [save, chosen]);
}

/** @param {Store} store */
function download(store) {
  const project = store.get(PROJECT);
  const content = new Blob([`${JSON.stringify(editsFile(project), null, 1)}\n`], { type: "application/json" });
  const link = el("a", { href: URL.createObjectURL(content), download: `${nameOf(project)}.edits.json` });
  link.click();
  URL.revokeObjectURL(link.href);
}

/** @param {Project} project */
function nameOf({ audio }) {
  return audio?.name.replace(/\.[^.]*$/, "") ?? "line";
}

/**
 * Has the line performed with the edits in a file; what is wrong with it is told.
 *
 * @param {Store} store
 * @param {File} file
 */
export async function loadEdits(store, file) {
  try {
    const read = /** @type {unknown} */ (JSON.parse(await file.text()));
    if (typeof read !== "object" || read === null || Array.isArray(read)) {
      throw new SyntaxError("it is no JSON object");
    }
    store.history.execute(new ChangeProject(store, `Load ${file.name}`, projectWith(store.get(PROJECT), read)));
  } catch (error) {
    store.set(PROBLEM, { ...problemOf(error), detail: `${file.name} is no file of edits: ${problemOf(error).detail}` });
  }
}
