/** The names of the rows at the left: a press folds a row, its lower edge (or + and −) makes it higher. */

import { el } from "../dom.js";
import { channelName } from "../naming/movements.js";
import { LOOKS, resizeRow, toggleRow } from "./looks.js";

/** @import { Store } from "../state/store.js" */
/** @import { PlacedRow } from "./layout.js" */

const STEP = 0.25;
const EDGE_PX = 5;

export class Gutter {
  element = el("div", { class: "gutter" });
  #store;
  #shown = "";

  /** @param {Store} store */
  constructor(store) {
    this.#store = store;
  }

  /** @param {readonly PlacedRow[]} rows */
  show(rows) {
    const key = JSON.stringify(rows.map(({ row, top_px, height_px, folded }) => [row.name, top_px, height_px, folded]));
    if (key === this.#shown) {
      return;
    }
    this.#shown = key;
    const focused = /** @type {HTMLElement | null} */ (this.element.querySelector(":focus"))?.dataset["row"];
    this.element.replaceChildren(...rows.flatMap((row) => [this.#name(row), this.#edge(row)]));
    /** @type {HTMLElement | null} */ (focused ? this.element.querySelector(`[data-row="${focused}"]`) : null)?.focus();
  }

  /** @param {PlacedRow} row */
  #name({ row: { name }, top_px, height_px, folded }) {
    const title = `${channelName(name)}: press to ${folded ? "unfold" : "fold"}, + and − make it higher and lower`;
    const button = el("button", { type: "button", "data-row": name, "aria-expanded": String(!folded), title, click: () => toggleRow(this.#store, name) }, [channelName(name)]);
    button.addEventListener("keydown", ({ key }) => {
      const way = key === "+" || key === "=" ? 1 : key === "-" ? -1 : 0;
      if (way !== 0) {
        resizeRow(this.#store, name, this.#share(name) + way * STEP);
      }
    });
    [button.style.top, button.style.height] = [`${String(top_px)}px`, `${String(Math.min(height_px, 20))}px`];
    return button;
  }

  /** @param {PlacedRow} row */
  #edge({ row: { name }, top_px, height_px, folded }) {
    const edge = el("span", { hidden: folded });
    edge.style.top = `${String(top_px + height_px - EDGE_PX / 2)}px`;
    edge.addEventListener("pointerdown", ({ clientY }) => {
      const before = this.#share(name);
      const move = (/** @type {PointerEvent} */ event) => resizeRow(this.#store, name, (before * (height_px + event.clientY - clientY)) / height_px);
      document.addEventListener("pointermove", move);
      document.addEventListener("pointerup", () => document.removeEventListener("pointermove", move), { once: true });
    });
    return edge;
  }

  /** @param {string} row */
  #share(row) {
    return this.#store.get(LOOKS).heights[row] ?? 1;
  }
}
