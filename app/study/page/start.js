/** Asks for the rater's number, by which orders are balanced, and says what is to be done. */

import { el, labelled } from "../../studio/page/dom.js";
import { Answers } from "./answers.js";
import { roundsOf } from "./plan.js";

/** @import { Store } from "./answers.js" */
/** @import { Plan } from "./plan.js" */

const TOLD = Object.freeze({
  modes:
    "A character speaks a line in three performances. Watch all three, with sound; then say how appropriate each of them is " +
    "to what is said and how, and which is the best and which the worst. Judge the body.",
  units:
    "A character speaks a line in two performances, A and B. Watch both, with sound; then say in which of them the character is " +
    "more natural, more friendly and so on. Judge intuitively, and by the body: the face is hidden.",
  ways:
    "A character speaks a line in two performances, A and B, which may be the same. Watch both, with sound; then say in which the " +
    "gestures look more natural, and by how much.",
  affect:
    "A character speaks a line in two performances, A and B, which may be the same. Watch both, with sound; then say in which the " +
    "body feels more as the voice does, and by how much.",
  speakers:
    "Two speakers gesture each in a way of his own. Get to know them; then say who gestures in other lines, first of one " +
    "performance, then of two side by side. The face is hidden.",
});

/**
 * @param {HTMLElement} element
 * @param {Plan} plan
 * @param {{ store: Store, lasts: boolean }} kept where answers are kept, and whether that lasts
 * @param {(rater: number) => void} started
 */
export function mountStart(element, plan, { store, lasts }, started) {
  const number = el("input", { type: "number", min: 1, step: 1, required: true, id: "rater", value: asked() });
  const note = el("p", { class: "quiet" });
  const tell = () => {
    const count = number.validity.valid && number.value ? new Answers(plan, number.valueAsNumber, store).count : 0;
    note.textContent = count > 0 ? `This rater has answered ${count} of ${roundsOf(plan, 1).length} rounds here, and goes on.` : "";
  };
  const begin = (/** @type {Event} */ event) => {
    event.preventDefault();
    started(number.valueAsNumber);
  };
  const form = el("form", { submit: begin }, [
    el("div", { class: "row" }, [labelled("Your number (from 1, as you were told)", number)]),
    note,
    el("button", { class: "main" }, ["Begin"]),
  ]);
  number.addEventListener("input", tell);
  tell();
  const kept = lasts
    ? "Your answers stay in this browser until you save them as a file. Nothing is sent anywhere."
    : "This browser keeps nothing for this page: save your answers as a file before you close it. Nothing is sent anywhere.";
  element.replaceChildren(el("h1", {}, ["Rating performances"]), el("p", {}, [TOLD[plan.comparison]]), el("p", {}, [kept]), form);
}

/** The number in the address, as in index.html?rater=7. */
function asked() {
  return new URLSearchParams(location.search).get("rater") ?? "";
}
