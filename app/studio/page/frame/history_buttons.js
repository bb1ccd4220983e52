/** Undo and redo: buttons that say what, and the usual keys. */

import { el } from "../dom.js";
import { icon } from "../icons.js";
import { DOABLE } from "../state/history.js";

/** @import { Store } from "../state/store.js" */

/**
 * @param {HTMLElement} element
 * @param {Store} store
 */
export function mountHistory(element, store) {
  const undo = el("button", { type: "button", id: "undo", class: "square", "aria-label": "Undo", click: () => store.history.undo() }, [icon("undo")]);
  const redo = el("button", { type: "button", id: "redo", class: "square", "aria-label": "Redo", click: () => store.history.redo() }, [icon("redo")]);
  element.append(undo, redo);
  store.watch(DOABLE, (doable) => {
    show(undo, "Undo", doable.undo);
    show(redo, "Redo", doable.redo);
  });
  document.addEventListener("keydown", (event) => onKey(event, store));
}

/**
 * @param {HTMLButtonElement} button
 * @param {string} name
 * @param {string | null} what
 */
function show(button, name, what) {
  button.disabled = what === null;
  button.title = what === null ? name : `${name}: ${what}`;
}

/**
 * @param {KeyboardEvent} event
 * @param {Store} store
 */
function onKey(event, store) {
  const isTyping = event.target instanceof Element && event.target.matches("input:not([type=checkbox]), textarea");
  const key = event.key.toLowerCase();
  if (isTyping || !(event.ctrlKey || event.metaKey) || !"yz".includes(key)) {
    return;
  }
  event.preventDefault();
  const isRedo = key === "y" || event.shiftKey;
  store.history[isRedo ? "redo" : "undo"]();
}
