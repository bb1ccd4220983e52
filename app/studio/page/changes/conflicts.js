/** What of the edits cannot be made, as the service tells it, and what was changed so far. */

import { el } from "../dom.js";
import { plainText } from "../naming/movements.js";
import { changeEdits, editsOf } from "./change_edits.js";

/** @import { Edits, Performance } from "understudy-client" */
/** @import { Store } from "../state/store.js" */

/** Where in the file of edits it is, which says nothing to whoever looks at the page. */
const PLACED = /^(?:behaviors|words)\[\d+\](?:\.\w+)*: /;
const PLACE = /^(behaviors|words)\[(\d+)\]/;

/**
 * @param {Store} store
 * @param {Performance} performance
 */
export function conflicts(store, performance) {
  const told = performance.warnings.filter(({ code }) => code.startsWith("edit_"));
  const items = told.map(({ code, message }) => el("li", { "data-code": code }, [plainText(message.replace(PLACED, "")), leaveOut(store, message)]));
  return items.length > 0
    ? [el("h3", {}, ["What no longer fits"]), el("ul", { id: "conflicts" }, items)]
    : [];
}

/**
 * A button that takes back the edit that a message is about.
 *
 * @param {Store} store
 * @param {string} message
 */
function leaveOut(store, message) {
  const found = PLACE.exec(message);
  const click = () => {
    const now = editsOf(store);
    const list = /** @type {"behaviors" | "words"} */ (found?.[1]);
    const kept = (now[list] ?? []).filter((_, index) => index !== Number(found?.[2]));
    changeEdits(store, "Leave an edit out", /** @type {Edits} */ ({ ...now, [list]: kept }));
  };
  return found ? el("button", { type: "button", click }, ["Leave out"]) : "";
}
