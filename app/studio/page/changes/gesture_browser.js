/** The gestures to choose from, as moving figures in groups by what they mean; found by name and by meaning. */

import { choice, el, labelled } from "../dom.js";
import { GROUPS, groupOf, searchedText } from "../naming/groups.js";
import { familyName } from "../naming/meanings.js";
import { movementName, plain } from "../naming/movements.js";
import { favourites, recent, remember, toggleFavourite } from "./favourites.js";
import { clipsOf } from "./gesture_clips.js";
import { thumbnail } from "./thumbnails.js";

/** @import { Service } from "../service/service.js" */
/** @import { Lexemes } from "./lexemes.js" */
/** @import { GestureClips } from "./gesture_clips.js" */

/** @typedef {Readonly<{ clips: GestureClips, lexemes: Lexemes, now: string, choose: (lexeme: string) => void }>} Shelf */

/**
 * Opens the browser; `chosen` is called with the lexeme that is chosen, if one is.
 *
 * @param {Service} service
 * @param {Lexemes} lexemes
 * @param {{ now: string, chosen: (lexeme: string) => void }} asked
 */
export function browseGestures(service, lexemes, { now, chosen }) {
  const clips = clipsOf(service);
  const dialog = el("dialog", { id: "gesture-browser", "aria-label": "Gestures" });
  const choose = (/** @type {string} */ lexeme) => {
    remember(lexeme);
    dialog.close();
    chosen(lexeme);
  };
  const shown = el("div", { class: "shelf" });
  const name = el("input", { type: "search", id: "gesture-name", placeholder: "“I don’t know”, big, point…" });
  const family = choice([["", "Anything"], ...lexemes.families.map(asOption)], lexemes.familiesOf(now)[0] ?? "", () => show());
  family.id = "gesture-family";
  const show = () => {
    const found = sections(lexemes, family.value, name.value);
    shown.replaceChildren(...found.map((section) => shelf({ clips, lexemes, now, choose }, section)));
    if (found.length === 0) {
      shown.append(el("p", { class: "quiet" }, ["No gesture is called that or means that. Try another word, such as “yes”, “big” or “over there”."]));
    }
  };
  name.addEventListener("input", show);
  openDialog(dialog, [labelled("Search", name), labelled("Suggest for", family)], shown);
  show();
}

/**
 * @param {HTMLDialogElement} dialog
 * @param {readonly HTMLElement[]} fields
 * @param {HTMLElement} shown
 */
function openDialog(dialog, fields, shown) {
  const close = el("button", { type: "button", click: () => dialog.close() }, ["Close"]);
  dialog.append(el("div", { class: "row" }, [...fields, close]), shown);
  dialog.addEventListener("close", () => dialog.remove());
  document.body.append(dialog);
  dialog.showModal();
}

/**
 * The lexemes of a family (empty: of all) in whose name or meaning all words of a text are, those that show the family
 * first coming first.
 *
 * @param {Lexemes} lexemes
 * @param {string} family
 * @param {string} text
 */
export function matching(lexemes, family, text) {
  const wanted = text.toLowerCase().split(/[\s_“”"-]+/).filter(Boolean);
  const found = lexemes.of("gesture").filter((lexeme) => {
    const searched = searchedText(lexeme, lexemes.familiesOf(lexeme));
    return wanted.every((word) => searched.includes(word));
  });
  const rank = (/** @type {string} */ lexeme) => lexemes.familiesOf(lexeme).indexOf(family);
  return family ? found.filter((lexeme) => rank(lexeme) >= 0).sort((a, b) => rank(a) - rank(b)) : found;
}

/**
 * Whether what is typed is all of a gesture's name.
 *
 * @param {string} lexeme
 * @param {string} text
 */
function isCalled(lexeme, text) {
  const typed = text.trim().toLowerCase();
  return movementName("gesture", lexeme).toLowerCase() === typed || lexeme.toLowerCase() === typed;
}

/**
 * Gestures under what they mean: first those of the family, then those that the author uses, then all. Where something is
 * searched, what is found alone, what is called exactly so before the rest.
 *
 * @param {Lexemes} lexemes
 * @param {string} family
 * @param {string} text
 */
export function sections(lexemes, family, text) {
  const found = matching(lexemes, "", text);
  const isSearched = text.trim() !== "";
  const first = isSearched ? found.filter((lexeme) => isCalled(lexeme, text)) : family ? matching(lexemes, family, text) : [];
  const rest = found.filter((lexeme) => !first.includes(lexeme));
  const own = isSearched ? [] : [{ title: "Recent", some: recent() }, { title: "Favourites", some: favourites() }];
  return [
    { title: isSearched ? "By this name" : `For “${familyName(family)}”`, found: first },
    ...own.map(({ title, some }) => ({ title, found: rest.filter((each) => some.includes(each)) })),
    ...GROUPS.map((group) => ({ title: group.name, found: rest.filter((each) => groupOf(lexemes.familiesOf(each)) === group) })),
  ].filter((section) => section.found.length > 0);
}

/**
 * @param {Shelf} from
 * @param {Readonly<{ title: string, found: readonly string[] }>} section
 */
function shelf(from, { title, found }) {
  return el("section", {}, [el("h3", {}, [title]), el("ul", { class: "gestures" }, found.map((lexeme) => entry(from, lexeme)))]);
}

/**
 * @param {Shelf} from
 * @param {string} lexeme
 */
function entry({ clips, lexemes, now, choose }, lexeme) {
  const read = lexemes.familiesOf(lexeme).map(familyName).join(", ");
  const name = movementName("gesture", lexeme);
  const button = el(
    "button",
    { type: "button", "data-lexeme": lexeme, "aria-pressed": String(lexeme === now), title: `${lexeme}: ${read}`, click: () => choose(lexeme) },
    [thumbnail(clips, lexeme), el("span", {}, [name])],
  );
  const star = el("button", { type: "button", class: "quiet square star", "aria-label": `Favourite: ${name}`, "aria-pressed": String(favourites().includes(lexeme)) }, ["★"]);
  star.addEventListener("click", () => star.setAttribute("aria-pressed", String(toggleFavourite(lexeme))));
  return el("li", {}, [button, star]);
}

/** @param {string} family */
function asOption(family) {
  return /** @type {const} */ ([family, plain(familyName(family))]);
}
