/** The lines of the scene beside the stage: which is spoken, and a press on one goes there. */

import { el } from "../dom.js";

/** @import { SceneLine } from "./scene_index.js" */
/** @import { Span } from "./sequence.js" */

export class Script {
  element = el("ol", { class: "script", "aria-label": "Lines" });
  #seek;
  /** @type {HTMLButtonElement[]} */
  #buttons = [];
  #marked = -1;

  /** @param {(time_s: number) => void} seek */
  constructor(seek) {
    this.#seek = seek;
  }

  /**
   * @param {readonly SceneLine[]} lines
   * @param {readonly Span[]} spans
   */
  show(lines, spans) {
    this.#marked = -1;
    this.#buttons = lines.map(({ speaker, text }, place) => {
      const go = () => this.#seek(spans[place]?.start_s ?? 0);
      return el("button", { type: "button", click: go }, [el("b", {}, [speaker]), ` ${text}`]);
    });
    this.element.replaceChildren(...this.#buttons.map((button) => el("li", {}, [button])));
  }

  /** @param {number} place of the line that is spoken */
  mark(place) {
    if (place !== this.#marked) {
      this.#buttons[this.#marked]?.removeAttribute("aria-current");
      this.#buttons[place]?.setAttribute("aria-current", "true");
      this.#buttons[place]?.scrollIntoView({ block: "nearest" });
      this.#marked = place;
    }
  }
}
