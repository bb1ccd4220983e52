/** Saves answers as a file, on the way and at the end. */

import { el } from "../../studio/page/dom.js";

/** @import { Answers } from "./answers.js" */
/** @import { Plan } from "./plan.js" */

/**
 * @param {Plan} plan
 * @param {Answers} answers
 */
export function saveButton(plan, answers) {
  const save = () => {
    const address = URL.createObjectURL(new Blob([answers.csv()], { type: "text/csv" }));
    el("a", { href: address, download: `answers-${plan.name}-${answers.rater}.csv` }).click();
    setTimeout(() => URL.revokeObjectURL(address), 60_000);
  };
  return el("button", { type: "button", id: "save", click: save }, ["Save my answers"]);
}

/**
 * @param {HTMLElement} element
 * @param {Plan} plan
 * @param {Answers} answers
 */
export function mountEnd(element, plan, answers) {
  const save = saveButton(plan, answers);
  save.classList.add("main");
  const told = "That was the last line. Save your answers and hand the file to whoever asked you. Thank you.";
  element.replaceChildren(el("h1", {}, ["Done"]), el("p", {}, [told]), save);
  save.focus();
}
