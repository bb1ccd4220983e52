/** The start page: one place for a recording, with its words or a whole project; the microphone, an example, what was worked on last. */

import { el, fileButton } from "../dom.js";
import { problemOf } from "../service/service.js";
import { PROBLEM } from "../state/performed.js";
import { PROJECT } from "../state/project.js";
import { recentLines } from "../saved/recent.js";
import { letFilesBeDropped, TAKEN, takeFiles } from "./dropping.js";
import { openExample, openKept } from "./opening.js";
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
  element.append(intro(), drop, recent.element, back);
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
  return el("div", {}, [
    el("h2", {}, ["Perform a spoken line"]),
    el("p", { class: "quiet" }, ["Give a recording and its words. You get gestures, head, gaze and face, each with its reason, to change and take away."]),
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
  const example = el("button", { type: "button", id: "example", click: () => void openExample(store, service) }, ["Try the example"]);
  return el("div", { class: "drop" }, [
    el("strong", {}, ["Drop a recording here"]),
    el("div", { class: "row" }, [chosen, record, example]),
    el("p", { class: "quiet" }, ["WAV, FLAC or OGG. With it, or later: its words (.txt), a body (.glb, .vrm), edits (.json). Or a saved project (.zip)."]),
  ]);
}
