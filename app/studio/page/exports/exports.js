/** Takes a line away: as files that the service writes, as pictures of the stage, as a project to go on with. */

import { fileButtons } from "../changes/edit_files.js";
import { choice, el } from "../dom.js";
import { problemOf } from "../service/service.js";
import { AVATAR, PERFORMED, PROBLEM } from "../state/performed.js";
import { PROJECT } from "../state/project.js";
import { SCREEN } from "../stage/viewing.js";
import { TAKES } from "../takes/takes.js";
import { film } from "./film.js";
import { FORMATS } from "./formats.js";
import { Making, MAKING } from "./making.js";
import { frames, sheet } from "./pictures.js";
import { projectFile } from "./project_file.js";

/** @import { Service } from "../service/service.js" */
/** @import { Store } from "../state/store.js" */
/** @import { Exported } from "./formats.js" */

/**
 * @param {HTMLElement} element
 * @param {Store} store
 * @param {Service} service
 */
export function mountExports(element, store, service) {
  const making = new Making(store);
  const made = buttons(store, making);
  const controls = el("fieldset", { disabled: true }, [
    part("Film and pictures", "What the stage shows, at 1920 × 1080.", el("div", { class: "row" }, made.pictures)),
    part("For another program", "The line as motion, behaviour (BML) or a list of times.", formatRow(store, service, making)),
    part("To go on later", "Recording, words, edits and takes in one file. Drop it on the page to go on.", el("div", { class: "row" }, [made.project])),
  ]);
  element.append(making.element, controls, part("Edits alone", "For the same line elsewhere, or for a whole script (batch).", fileButtons(store)));
  for (const of of [PERFORMED, MAKING]) {
    store.watch(/** @type {typeof MAKING} */ (of), () => (controls.disabled = store.get(PERFORMED) === null || store.get(MAKING)));
  }
}

/**
 * @param {string} title
 * @param {string} hint
 * @param {HTMLElement} controls
 */
function part(title, hint, controls) {
  return el("section", { class: "export" }, [el("h3", {}, [title]), el("p", { class: "quiet" }, [hint]), controls]);
}

/**
 * @param {Store} store
 * @param {Service} service
 * @param {Making} making
 */
function formatRow(store, service, making) {
  const names = [...FORMATS].map(([ending, { name }]) => /** @type {const} */ ([ending, `${name} (${ending})`]));
  const format = choice(names, ".bml", () => undefined);
  format.id = "format";
  format.ariaLabel = "Format";
  const click = () => {
    const write = FORMATS.get(format.value)?.write;
    void offer(store, making, format.value, (exported) => write?.(service, exported));
  };
  return el("div", { class: "row" }, [format, el("button", { type: "button", id: "export", click }, ["Save file"])]);
}

/**
 * @param {Store} store
 * @param {Making} making
 */
function buttons(store, making) {
  const tell = (/** @type {number} */ share) => making.tell(share);
  const screen = () => {
    const found = store.get(SCREEN);
    if (!found) {
      throw new Error("there is no stage to take pictures of");
    }
    return found;
  };
  const button = (/** @type {string} */ name, /** @type {string} */ ending, /** @type {(exported: Exported) => Promise<Blob>} */ make) =>
    el("button", { type: "button", click: () => void offer(store, making, ending, make) }, [name]);
  const pictures = [
    button("Film (WebM)", ".webm", ({ performed }) => film(store, screen(), lengthOf(performed), tell)),
    button("Frames (PNG)", ".frames.zip", ({ performed }) => frames(store, screen(), lengthOf(performed), tell)),
    button("Still sheet", ".png", ({ performed }) => sheet(store, screen(), performed.performance)),
  ];
  return { pictures, project: button("Project (zip)", ".studio.zip", ({ line }) => projectFile(line, store.get(TAKES))) };
}

/** @param {Exported["performed"]} performed */
function lengthOf({ performance }) {
  return performance.lead_in_s + performance.audio.duration_s;
}

/**
 * Makes a file of the line as it is now and has the browser save it; what goes wrong is told.
 *
 * @param {Store} store
 * @param {Making} making
 * @param {string} ending
 * @param {(exported: Exported) => Promise<Blob> | undefined} make
 */
async function offer(store, making, ending, make) {
  const performed = store.get(PERFORMED);
  const { audio, ...project } = store.get(PROJECT);
  if (!performed || !audio) {
    return;
  }
  const name = audio.name.replace(/\.[^.]*$/, "") + ending;
  try {
    const content = await making.make(async () => make({ line: { ...project, audio }, performed, avatar: store.get(AVATAR) }));
    if (content) {
      save(content, name);
      making.say(`${name}: ${String(Math.ceil(content.size / 1024))} KB`);
    }
  } catch (error) {
    store.set(PROBLEM, problemOf(error));
  }
}

/**
 * @param {Blob} content
 * @param {string} name
 */
function save(content, name) {
  const url = URL.createObjectURL(content);
  el("a", { href: url, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(url), 60_000);
}
