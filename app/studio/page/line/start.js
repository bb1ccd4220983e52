/** The start page: one place for a recording, with its words or a whole project; the microphone, an example, what was worked on last. */

import { el, fileButton, labelled } from "../dom.js";
import { problemOf } from "../service/service.js";
import { PROBLEM } from "../state/performed.js";
import { icon } from "../icons.js";
import { PROJECT, unrecorded } from "../state/project.js";
import { recentLines } from "../saved/recent.js";
import { letFilesBeDropped, TAKEN, takeFiles } from "./dropping.js";
import { open, openExample, openKept } from "./opening.js";
import { microphone } from "./microphone.js";
import { STARTING } from "./starting.js";

/** @import { Service } from "../service/service.js" */
/** @import { Store } from "../state/store.js" */

/**
 * @param {HTMLElement} element
 * @param {Store} store
 * @param {Service} service
 */
export function mountStart(element, store, service) {
  const recent = recentLines((project) => openKept(store, project));
  const back = el("button", { type: "button", id: "back-to-line", click: () => store.set(STARTING, false) }, ["Back to the line"]);
  const drop = dropZone(store, service);
  element.append(intro(), drop, written(store), recent.element, back);
  letFilesBeDropped(store, drop);
  const show = () => {
    const isEmpty = store.get(PROJECT).audio === null;
    const isShown = isEmpty || store.get(STARTING);
    element.hidden = !isShown;
    element.parentElement?.classList.toggle("empty", isShown);
    back.hidden = isEmpty;
    if (isShown) {
      void recent.show();
    }
  };
  for (const of of [PROJECT, STARTING]) {
    store.watch(/** @type {typeof STARTING} */ (of), show);
  }
}

function intro() {
  return el("div", { class: "intro" }, [
    el("h2", {}, ["Perform a spoken line"]),
    el("p", { class: "quiet" }, ["Give a recording and its words. You get gestures, head, gaze and face, each with its reason, to edit and to export."]),
  ]);
}

/**
 * @param {Store} store
 * @param {Service} service
 */
function dropZone(store, service) {
  const taken = (/** @type {File[]} */ files) => void takeFiles(store, files);
  const chosen = fileButton("Choose a recording…", { id: "files", multiple: true, accept: TAKEN, class: "primary" }, taken);
  const told = (/** @type {unknown} */ error) => store.set(PROBLEM, problemOf(error));
  const record = microphone((file) => taken([file]), told);
  const example = el("button", { type: "button", id: "example", click: () => void openExample(store, service) }, [icon("play"), "Try the example"]);
  return el("div", { class: "drop" }, [
    el("strong", {}, ["Drop a recording here"]),
    el("div", { class: "row" }, [chosen, record, example]),
    el("p", { class: "quiet" }, ["WAV, FLAC or OGG, with its words (.txt) if you have them, or a saved project (.zip)"]),
  ]);
}

/**
 * A line that is only written: its words alone are performed, until a recording is dropped.
 *
 * @param {Store} store
 */
function written(store) {
  const typed = el("textarea", { id: "written", rows: 2, placeholder: "No, I have *never* seen those.", "aria-describedby": "written-hint" });
  const perform = el("button", { type: "submit", id: "perform-written", disabled: true }, [icon("text"), "Perform the text"]);
  typed.addEventListener("input", () => (perform.disabled = typed.value.trim() === ""));
  const submit = (/** @type {Event} */ event) => {
    event.preventDefault();
    open(store, { audio: unrecorded(typed.value), text: typed.value.trim() });
    typed.value = "";
  };
  const hint = el("p", { class: "quiet", id: "written-hint" }, ["Put *stars* around words that are stressed. Drop the recording later."]);
  return el("form", { class: "written", submit }, [labelled("No recording yet? Type the line", typed), el("div", { class: "row" }, [hint, perform])]);
}
