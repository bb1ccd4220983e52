/** Says whether the line is kept, and opens the list of its versions, each of which can be restored (and that undone). */

import { el } from "../dom.js";
import { icon } from "../icons.js";
import { problemOf } from "../service/service.js";
import { ChangeProject } from "../state/change_project.js";
import { PROBLEM } from "../state/performed.js";
import { OPENED, PROJECT } from "../state/project.js";
import { SAVING } from "./autosave.js";
import { versions } from "./shelf.js";

/** @import { Store } from "../state/store.js" */
/** @import { Version } from "./shelf.js" */

const WORDS = Object.freeze({ same: "Versions", unsaved: "Saving…", saved: "Saved", failed: "Not saved" });
const TITLES = Object.freeze({
  same: "Every change is kept in this browser; press for earlier versions",
  unsaved: "The last change is being kept",
  saved: "Kept in this browser; press for earlier versions",
  failed: "The browser cannot keep the line: save it as a project under Export",
});

/**
 * @param {HTMLElement} element
 * @param {Store} store
 */
export function mountSaving(element, store) {
  const list = el("div", { id: "versions", class: "floating", role: "region", "aria-label": "Versions", hidden: true });
  const button = el("button", { type: "button", id: "saved", class: "quiet", "aria-expanded": "false", "aria-controls": list.id });
  const toggle = (/** @type {boolean} */ isOpen) => {
    list.hidden = !isOpen;
    button.setAttribute("aria-expanded", String(isOpen));
    if (isOpen) {
      fill(list, store, () => toggle(false)).catch((error) => store.set(PROBLEM, problemOf(error)));
    }
  };
  button.addEventListener("click", () => toggle(list.hidden));
  element.addEventListener("keydown", ({ key }) => key === "Escape" && toggle(false));
  element.append(button, list);
  store.watch(PROJECT, ({ audio }) => {
    button.disabled = audio === null;
    toggle(false);
  });
  store.watch(SAVING, (saving) => {
    button.dataset["saving"] = saving;
    button.classList.toggle("wrong", saving === "failed");
    button.replaceChildren(icon("history"), WORDS[saving]);
    button.title = TITLES[saving];
  });
}

/**
 * @param {HTMLElement} list
 * @param {Store} store
 * @param {() => void} close
 */
async function fill(list, store, close) {
  const found = await versions(store.get(OPENED).id);
  const rows = found.map((version) => row(store, version, close));
  const none = el("p", { class: "quiet" }, ["No version yet: one is kept with the first change, and then at most every 20 seconds."]);
  list.replaceChildren(el("h2", {}, ["Versions"]), rows.length > 0 ? el("ul", { class: "versions" }, rows) : none);
}

/**
 * @param {Store} store
 * @param {Version} version
 * @param {() => void} close
 */
function row(store, { draft, label, saved_ms }, close) {
  const time = new Date(saved_ms).toLocaleTimeString([], { hour: "2-digit", minute: "2-digit", second: "2-digit" });
  const restore = () => {
    store.history.execute(new ChangeProject(store, `Restore ${time}`, draft));
    close();
  };
  return el("li", {}, [el("span", {}, [`${time}  ${label}`]), el("button", { type: "button", click: restore }, ["Restore"])]);
}
