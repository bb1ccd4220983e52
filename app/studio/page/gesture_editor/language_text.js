/** The gesture in its language: as it will be saved, to be written too; with every mistake at its line and column. */

import { el, labelled, readOut } from "../dom.js";
import { goTo } from "../text_place.js";
import { takeText, TYPED } from "./checking.js";
import { CHECKED } from "./gestures.js";

/** @import { CheckedGestures } from "understudy-client" */
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
    store.set(TYPED, typed.value);
    timer = window.setTimeout(() => void takeText(store, service, { text: typed.value }), QUIET_MS);
  });
  store.watch(CHECKED, (checked) => {
    if (checked && typed.value !== checked.text) {
      typed.value = checked.text;
    }
    mistakes.replaceChildren(...(checked ? told(checked, typed) : []));
  });
  return el("section", { class: "gesture-language" }, [labelled("In the gesture language", typed), readOut(mistakes)]);
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
