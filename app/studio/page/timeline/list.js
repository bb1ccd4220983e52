/** The items of the timeline as a list, for the keyboard and for those who do not see the canvas. */

import { el } from "../dom.js";
import { channelName } from "../naming/movements.js";
import { SELECTION } from "../state/performed.js";
import { selectAndSeek } from "../state/selecting.js";
import { listed } from "./tracks.js";

/** @import { Store } from "../state/store.js" */
/** @import { Item, Row } from "./tracks.js" */

/**
 * A list in which the arrows move the selection. `show(rows)` fills it.
 *
 * @param {Store} store
 */
export function makeList(store) {
  const list = el("ul", { id: "items", role: "listbox", tabindex: 0, "aria-label": "Everything on the timeline" });
  list.addEventListener("keydown", (event) => onKey(event, store, list));
  list.addEventListener("click", ({ target }) => {
    const row = target instanceof Element ? target.closest("li") : null;
    if (row) {
      selectAndSeek(store, row.dataset["id"] ?? null);
    }
  });
  store.watch(SELECTION, (id) => mark(list, id));
  const show = (/** @type {readonly Row[]} */ rows) => {
    list.replaceChildren(...listed(rows).map(({ row, item }, index) => entry(row, item, index)));
    mark(list, store.get(SELECTION));
  };
  return { list, show };
}

/**
 * @param {string} row
 * @param {Item} item
 * @param {number} index
 */
function entry(row, { id, label, technical, start_s, end_s, kept, why }, index) {
  const times = `${start_s.toFixed(2)}–${end_s.toFixed(2)} s`;
  const title = `${row === "words" ? "word" : row} ${technical}${kept ? "" : `, dropped: ${why}`}`;
  const attributes = { id: `item-${String(index)}`, role: "option", "data-id": id, "aria-selected": "false", title };
  const name = el("b", {}, [kept ? label : `${label}: ${why}`]);
  const told = [name, el("span", {}, [channelName(row)]), el("span", {}, [times])];
  return el("li", kept ? attributes : { ...attributes, class: "dropped" }, told);
}

/**
 * @param {HTMLElement} list
 * @param {string | null} id
 */
function mark(list, id) {
  list.removeAttribute("aria-activedescendant");
  for (const row of list.querySelectorAll("li")) {
    const isSelected = id !== null && row.dataset["id"] === id;
    row.setAttribute("aria-selected", String(isSelected));
    if (isSelected) {
      list.setAttribute("aria-activedescendant", row.id);
      row.scrollIntoView({ block: "nearest" });
    }
  }
}

/** @type {Readonly<Record<string, number>>} */
const STEPS = Object.freeze({ ArrowUp: -1, ArrowDown: 1, Home: -Infinity, End: Infinity });

/**
 * @param {KeyboardEvent} event
 * @param {Store} store
 * @param {HTMLElement} list
 */
function onKey(event, store, list) {
  const step = STEPS[event.key];
  if (step === undefined) {
    return;
  }
  event.preventDefault();
  const rows = [...list.querySelectorAll("li")];
  const now = rows.findIndex((row) => row.dataset["id"] === store.get(SELECTION));
  const next = rows[Math.min(rows.length - 1, Math.max(0, now + step))];
  selectAndSeek(store, next?.dataset["id"] ?? null);
}
