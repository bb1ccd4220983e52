/** The gestures to choose from, as moving pictures: by family and by name. */

import { choice, el, labelled } from "../dom.js";
import { GestureClips, thumbnail } from "./thumbnails.js";

/** @import { Service } from "../service/service.js" */
/** @import { Lexemes } from "./lexemes.js" */

/** Clips stay for the next time, as long as the service is the same. @type {WeakMap<Service, GestureClips>} */
const CLIPS = new WeakMap();

/**
 * Opens the browser; `chosen` is called with the lexeme that is chosen, if one is.
 *
 * @param {Service} service
 * @param {Lexemes} lexemes
 * @param {{ now: string, chosen: (lexeme: string) => void }} asked
 */
export function browseGestures(service, lexemes, { now, chosen }) {
  const clips = CLIPS.get(service) ?? new GestureClips(service);
  CLIPS.set(service, clips);
  const dialog = el("dialog", { id: "gesture-browser", "aria-label": "Gestures" });
  const choose = (/** @type {string} */ lexeme) => {
    dialog.close();
    chosen(lexeme);
  };
  const shown = el("ul", { class: "gestures" });
  const name = el("input", { type: "search", id: "gesture-name" });
  const family = choice([["", "Every family"], ...lexemes.families.map(asOption)], lexemes.familiesOf(now)[0] ?? "", () => show());
  family.id = "gesture-family";
  const show = () => {
    const found = matching(lexemes, family.value, name.value);
    shown.replaceChildren(...found.map((lexeme) => entry(clips, lexemes, { lexeme, now, choose })));
  };
  name.addEventListener("input", show);
  const close = el("button", { type: "button", click: () => dialog.close() }, ["Close"]);
  dialog.append(el("div", { class: "row" }, [labelled("Family", family), labelled("Name", name), close]), shown);
  dialog.addEventListener("close", () => dialog.remove());
  document.body.append(dialog);
  show();
  dialog.showModal();
}

/**
 * The lexemes of a family (empty: of all) whose name has a text in it, those that show the family first coming first.
 *
 * @param {Lexemes} lexemes
 * @param {string} family
 * @param {string} text
 */
export function matching(lexemes, family, text) {
  const wanted = text.trim().toUpperCase().replaceAll(/[\s-]+/g, "_");
  const found = lexemes.of("gesture").filter((lexeme) => lexeme.includes(wanted));
  const rank = (/** @type {string} */ lexeme) => lexemes.familiesOf(lexeme).indexOf(family);
  return family ? found.filter((lexeme) => rank(lexeme) >= 0).sort((a, b) => rank(a) - rank(b)) : found;
}

/**
 * @param {GestureClips} clips
 * @param {Lexemes} lexemes
 * @param {{ lexeme: string, now: string, choose: (lexeme: string) => void }} shown
 */
function entry(clips, lexemes, { lexeme, now, choose }) {
  const read = lexemes.familiesOf(lexeme).join(", ");
  const button = el(
    "button",
    { type: "button", "data-lexeme": lexeme, "aria-pressed": String(lexeme === now), title: read, click: () => choose(lexeme) },
    [thumbnail(clips, lexeme), el("span", {}, [lexeme])],
  );
  return el("li", {}, [button]);
}

/** @param {string} family */
function asOption(family) {
  return /** @type {const} */ ([family, family.replaceAll("_", " ")]);
}
