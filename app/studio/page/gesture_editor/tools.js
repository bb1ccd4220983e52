/** What is done with gestures as files: a new one, one that is opened or taken from the library, and saving. */

import { el, fileButton, labelled } from "../dom.js";
import { problemOf } from "../service/service.js";
import { PROBLEM } from "../state/performed.js";
import { takeText } from "./checking.js";
import { ChangeGestures, EDITED, FIRST, FRAME } from "./gestures.js";
import { askWhereToSave, download, IS_WRITABLE, save, SAVED } from "./saving.js";

/** @import { Gestures } from "understudy-client" */
/** @import { Service } from "../service/service.js" */
/** @import { Store } from "../state/store.js" */

/**
 * @param {Store} store
 * @param {Service} service
 */
export function tools(store, service) {
  const read = async (/** @type {File[]} */ [file]) => file && takeText(store, service, { text: await file.text() });
  const open = fileButton("Open…", { id: "gesture-file", accept: ".gesture,.txt" }, (files) => void read(files));
  const library = el("input", { id: "gesture-library", list: "gesture-names", autocomplete: "off", placeholder: "Name of a gesture" });
  const names = el("datalist", { id: "gesture-names" });
  library.addEventListener("focus", () => void fill(store, service, names), { once: true });
  library.addEventListener("change", () => {
    if (library.value) {
      void takeText(store, service, { library: library.value.trim() });
    }
  });
  const fresh = el("button", { type: "button", id: "gesture-new", click: () => begin(store) }, ["New"]);
  return el("div", { class: "tools inline", role: "toolbar", "aria-label": "Gesture files" }, [fresh, open, labelled("From the library", library), names, ...saving(store, service)]);
}

/**
 * Saving into the author's folder where there is one, else as a file; a file can be had in either case.
 *
 * @param {Store} store
 * @param {Service} service
 */
function saving(store, service) {
  const keep = () => (store.get(IS_WRITABLE) ? void save(store, service) : void download(store, service));
  const kept = el("button", { type: "button", id: "gesture-save", class: "primary", click: keep }, ["Save"]);
  const file = el("button", { type: "button", id: "gesture-download", click: () => void download(store, service) }, ["Download"]);
  const told = el("output", { id: "gesture-saved", class: "quiet" });
  store.watch(IS_WRITABLE, (isWritable) => {
    file.hidden = !isWritable;
    kept.title = isWritable ? "Saves the gesture into the author's folder" : "Saves the gesture as a file";
  });
  store.watch(SAVED, (saved) => (told.value = saved));
  store.watch(EDITED, () => store.set(SAVED, ""));
  void askWhereToSave(store, service);
  return [told, file, kept];
}

/** @param {Store} store */
function begin(store) {
  store.set(FRAME, 0);
  store.history.execute(new ChangeGestures(store, "New gesture", { gestures: [FIRST], index: 0 }));
}

/**
 * @param {Store} store
 * @param {Service} service
 * @param {HTMLElement} names
 */
async function fill(store, service, names) {
  try {
    const { gestures } = /** @type {Gestures} */ (await service.client.listGestures());
    names.replaceChildren(...gestures.map(({ name }) => el("option", { value: name })));
  } catch (error) {
    store.set(PROBLEM, problemOf(error));
  }
}
