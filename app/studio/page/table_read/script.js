/**
 * The script beside the stage, scene by scene, everybody in his colour: which line is spoken, a press on one goes there;
 * each can be noted on, and opened on the stage of a line.
 */

import { el } from "../dom.js";
import { icon } from "../icons.js";
import { noteOn, takeNote } from "./notes.js";
import { colourOf, scenesOf } from "./scenes.js";

/** @import { SceneLine } from "./scene_index.js" */
/** @import { Span } from "./sequence.js" */

/** What is shown. @typedef {Readonly<{ script: string, lines: readonly SceneLine[], spans: readonly Span[], cast: readonly string[] }>} Shown */

/**
 * What a line can be asked to do.
 *
 * @typedef {Readonly<{ seek: (time_s: number) => void, play: (time_s: number) => void, open: (line: SceneLine) => void }>} Doing
 */

export class Script {
  element = el("div", { class: "script", role: "region", "aria-label": "Script", tabindex: 0 });
  #doing;
  /** @type {HTMLButtonElement[]} */
  #buttons = [];
  #marked = -1;

  /** @param {Doing} doing */
  constructor(doing) {
    this.#doing = doing;
  }

  /** @param {Shown} shown */
  show(shown) {
    this.#marked = -1;
    this.#buttons = [];
    const cast = el("ul", { class: "cast", "aria-label": "Cast" }, shown.cast.map((name) => el("li", { class: `cast-${String(colourOf(shown.cast, name))}` }, [name])));
    const scenes = scenesOf(shown.lines).flatMap(({ name, places }) => [
      ...(name ? [el("h3", {}, [name])] : []),
      el("ol", { "aria-label": name || "Lines" }, places.map((place) => this.#line(shown, place))),
    ]);
    this.element.replaceChildren(cast, ...scenes);
  }

  /**
   * @param {Shown} shown
   * @param {number} place
   */
  #line({ script, lines, spans, cast }, place) {
    const line = /** @type {SceneLine} */ (lines[place]);
    const start_s = spans[place]?.start_s ?? 0;
    const go = el("button", { type: "button", class: "said", click: () => this.#doing.seek(start_s) }, [el("b", {}, [line.speaker]), ` ${line.text}`]);
    this.#buttons[place] = go;
    const note = el("input", { type: "text", class: "note", placeholder: "Note…", "aria-label": `Note on ${line.id}`, value: noteOn(script, line.id) });
    note.addEventListener("change", () => takeNote(script, line.id, note.value.trim()));
    const play = el("button", { type: "button", class: "quiet", title: "Play from here", "aria-label": `Play from ${line.id} on`, click: () => this.#doing.play(start_s) }, [icon("play")]);
    const open = el("button", { type: "button", class: "quiet", title: "Open this line in the view Line, to change it", "aria-label": `Open in Line: ${line.id}`, click: () => this.#doing.open(line) }, ["Open in Line"]);
    return el("li", { class: `cast-${String(colourOf(cast, line.speaker))}` }, [go, el("div", { class: "beside-line" }, [play, note, open])]);
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
