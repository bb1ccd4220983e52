/** The gesture in its language: as it will be saved, to be written too; with every mistake at its line and column. */

import { el, labelled, readOut } from "../dom.js";
import { problemOf } from "../service/service.js";
import { PROBLEM } from "../state/performed.js";
import { goTo } from "../text_place.js";
import { takeText } from "./checking.js";
import { ChangeGestures, CHECKED, EDITED, FIRST, FRAME, gestureOf } from "./gestures.js";

/** @import { CheckedGestures, Gestures } from "understudy-client" */
/** @import { Service } from "../service/service.js" */
/** @import { Store } from "../state/store.js" */

const QUIET_MS = 300;

/**
 * @param {Store} store
 * @param {Service} service
 */
export function languageText(store, service) {
  const typed = el("textarea", { id: "gesture-text", rows: 14, spellcheck: false, wrap: "off" });
  const mistakes = el("ul", { id: "gesture-mistakes", class: "mistakes" });
  let timer = 0;
  typed.addEventListener("input", () => {
    clearTimeout(timer);
    timer = window.setTimeout(() => void takeText(store, service, { text: typed.value }), QUIET_MS);
  });
  store.watch(CHECKED, (checked) => {
    if (checked && typed.value !== checked.text) {
      typed.value = checked.text;
    }
    mistakes.replaceChildren(...(checked ? told(checked, typed) : []));
  });
  return el("section", { class: "gesture-language" }, [files(store, service), labelled("In the gesture language", typed), readOut(mistakes)]);
}

/**
 * @param {CheckedGestures} checked
 * @param {HTMLTextAreaElement} typed
 */
function told({ mistakes, doubts }, typed) {
  const wrong = mistakes.map((mistake) => {
    const place = `${String(mistake.line)}:${String(mistake.column)}`;
    const go = el("button", { type: "button", class: "link", click: () => goTo(typed, mistake) }, [place]);
    return el("li", { class: "wrong" }, [go, ` ${mistake.message}`]);
  });
  return [...wrong, ...doubts.map(({ gesture, time, level, message }) => el("li", {}, [`${gesture} at ${String(time)}, ${level} agitation: ${message}`]))];
}

/**
 * @param {Store} store
 * @param {Service} service
 */
function files(store, service) {
  const open = el("input", { type: "file", id: "gesture-file", accept: ".gesture,.txt" });
  open.addEventListener("change", () => void read(store, service, open));
  const library = el("input", { id: "gesture-library", list: "gesture-names", autocomplete: "off", placeholder: "name" });
  const names = el("datalist", { id: "gesture-names" });
  library.addEventListener("focus", () => void fill(store, service, names), { once: true });
  library.addEventListener("change", () => {
    if (library.value) {
      void takeText(store, service, { library: library.value.trim() });
    }
  });
  const fresh = el("button", { type: "button", id: "gesture-new", click: () => begin(store) }, ["New"]);
  const save = el("button", { type: "button", id: "gesture-save", click: () => download(store) }, ["Save"]);
  return el("div", { class: "row" }, [fresh, save, labelled("Open a .gesture file", open), labelled("From the library", library), names]);
}

/** @param {Store} store */
function begin(store) {
  store.set(FRAME, 0);
  store.history.execute(new ChangeGestures(store, "New gesture", { gestures: [FIRST], index: 0 }));
}

/**
 * @param {Store} store
 * @param {Service} service
 * @param {HTMLInputElement} open
 */
async function read(store, service, open) {
  const [file] = open.files ?? [];
  if (file) {
    await takeText(store, service, { text: await file.text() });
    open.value = "";
  }
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

/** @param {Store} store */
function download(store) {
  const checked = store.get(CHECKED);
  if (checked) {
    const url = URL.createObjectURL(new Blob([checked.text], { type: "text/plain" }));
    el("a", { href: url, download: `${gestureOf(store.get(EDITED)).name}.gesture` }).click();
    URL.revokeObjectURL(url);
  }
}
