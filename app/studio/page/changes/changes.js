/**
 * The inspector: what is selected and why it is there, what can be changed in it, and what of the changes no longer fits;
 * below stand the rules and numbers (reasons/). Dragging on the timeline and its keys come to the same changes.
 */

import { el } from "../dom.js";
import { redraw } from "../redrawing.js";
import { PERFORMED, SELECTION } from "../state/performed.js";
import { BADGES } from "../timeline/pointing.js";
import { editOfSelected, madeOf, selectedBehavior } from "./behaviors.js";
import { conflicts } from "./conflicts.js";
import { moveWhatIsDragged } from "./dragging.js";
import { editOf } from "./edits.js";
import { keepSelected } from "./following.js";
import { inspector } from "./inspector.js";
import { followKeys } from "./keys.js";
import { askForLexemes, LEXEMES } from "./lexemes.js";
import { clipsOf } from "./gesture_clips.js";
import { thumbnail } from "./thumbnails.js";
import { keepChosenHands } from "./pinning.js";
import { wordPanel } from "./word_panel.js";
import { wordOf } from "./words.js";
import { saidOf } from "../reasons/sentences.js";

/** @import { Behavior } from "understudy-client" */
/** @import { Service } from "../service/service.js" */
/** @import { Store } from "../state/store.js" */

/**
 * @param {HTMLElement} element
 * @param {Store} store
 * @param {Service} service
 */
export function mountChanges(element, store, service) {
  const selected = el("div", { id: "selected" });
  const told = el("div", { role: "status" });
  element.append(selected, told);
  keepSelected(store);
  keepChosenHands(store);
  const show = () => showSelected(selected, store, service);
  for (const of of [PERFORMED, SELECTION, LEXEMES]) {
    store.watch(/** @type {typeof SELECTION} */ (of), show);
  }
  store.watch(PERFORMED, (line) => {
    told.replaceChildren(...(line ? conflicts(store, line.performance) : []));
    store.set(BADGES, badges(store));
  });
  moveWhatIsDragged(store);
  const timeline = document.getElementById("timeline");
  if (timeline) {
    followKeys(timeline, store);
  }
  void askForLexemes(store, service);
}

/**
 * Fills the panel anew.
 *
 * @param {HTMLElement} element
 * @param {Store} store
 * @param {Service} service
 */
function showSelected(element, store, service) {
  const line = store.get(PERFORMED);
  const [lexemes, behavior, index] = [store.get(LEXEMES), selectedBehavior(store), wordOf(store.get(SELECTION))];
  const said = line && saidOf(line.performance, store.get(SELECTION) ?? "", editOfSelected(store) ?? undefined);
  if (!line || !said) {
    redraw(element, [el("p", { class: "quiet" }, [HINT])]);
    return;
  }
  const word = index === null ? [] : wordPanel(store, service, lexemes, { performance: line.performance, index });
  const fields = behavior ? inspector(store, service, lexemes, behavior) : word;
  redraw(element, [heading(pictureOf(service, behavior), said), el("p", { id: "why" }, [said.why]), ...fields]);
}

/**
 * A gesture as a moving figure; nothing for other movements.
 *
 * @param {Service} service
 * @param {Behavior | null} behavior
 */
function pictureOf(service, behavior) {
  return behavior?.kind === "gesture" ? [thumbnail(clipsOf(service), behavior.lexeme)] : [];
}

/**
 * @param {readonly Node[]} picture
 * @param {Readonly<{ name: string, technical: string, about: string }>} said
 */
function heading(picture, { name, technical, about }) {
  return el("div", { class: "what" }, [...picture, el("div", {}, [el("h3", { title: technical }, [name]), el("p", { class: "quiet about" }, [about])])]);
}

const HINT = "Select a movement or a word on the timeline to see what it is, change it, and read why it is there.";

/**
 * What was changed, by the behaviour's id.
 *
 * @param {Store} store
 */
function badges(store) {
  const made = madeOf(store);
  const marked = made?.performance.behaviors.flatMap((behavior) => {
    const edit = editOf(made, behavior);
    return edit ? [[behavior.id, edit.lock ? "locked" : (edit.omit ?? (edit.add ? "added" : "changed"))]] : [];
  });
  return /** @type {Record<string, string>} */ (Object.fromEntries(marked ?? []));
}
