/** What is done with gestures as files: a new one, one that is opened or taken from the library, and saving. */

import { el, fileButton, labelled } from "../dom.js";
import { problemOf } from "../service/service.js";
import { PROBLEM } from "../state/performed.js";
import { takeText, textNow } from "./checking.js";
import { ChangeGestures, EDITED, FIRST, FRAME, gestureOf } from "./gestures.js";

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
  const library = el("input", { id: "gesture-library", list: "gesture-names", autocomplete: "off", placeholder: "name" });
  const names = el("datalist", { id: "gesture-names" });
  library.addEventListener("focus", () => void fill(store, service, names), { once: true });
  library.addEventListener("change", () => {
    if (library.value) {
      void takeText(store, service, { library: library.value.trim() });
    }
  });
  const fresh = el("button", { type: "button", id: "gesture-new", click: () => begin(store) }, ["New"]);
  const save = el("button", { type: "button", id: "gesture-save", class: "primary", click: () => void download(store, service) }, ["Save"]);
  return el("div", { class: "tools inline", role: "toolbar", "aria-label": "Gesture files" }, [fresh, open, labelled("From the library", library), names, save]);
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

/**
 * @param {Store} store
 * @param {Service} service
 */
async function download(store, service) {
  const text = await textNow(store, service);
  if (text !== null) {
    const url = URL.createObjectURL(new Blob([text], { type: "text/plain" }));
    el("a", { href: url, download: `${gestureOf(store.get(EDITED)).name}.gesture` }).click();
    URL.revokeObjectURL(url);
  }
}
