/**
 * The papers' questions: grades from 1 to 10 with the best and the worst (§5), which clip is more … (NGS §4.1), whose
 * gestures they are (NGS §3.5), which of two is more natural and by how much (RTS §3.2).
 */

import { el } from "../../studio/page/dom.js";
import { letter } from "./plan.js";

/** @import { Row } from "./answers.js" */
/** @import { Plan, Round } from "./plan.js" */

/** A fieldset that is disabled until the clips are seen, and what it has been answered. @typedef {{ element: HTMLFieldSetElement, rows: () => Row[] }} Questions */

const UNDERSTANDING = ["nothing or little", "some of it", "all or nearly all"];

/**
 * @param {Plan} plan
 * @param {Round} round
 * @returns {Questions}
 */
export function modeQuestions({ grades: [lowest, highest] }, { clips }) {
  const values = Array.from({ length: highest - lowest + 1 }, (_, index) => String(lowest + index));
  const grades = clips.map((_, place) => {
    const asked = `How appropriate is performance ${letter(place)}? ${lowest} is not at all, ${highest} very appropriate.`;
    return radios(`grade-${place}`, asked, values.map((value) => [value, value]));
  });
  const letters = clips.map((_, place) => /** @type {const} */ ([String(place), letter(place)]));
  const best = radios("best", "Which is the best?", letters);
  const worst = radios("worst", "Which is the worst?", letters);
  notTheSame(best, worst);
  const rows = () =>
    clips.map((clip, place) => {
      const choice = chosen(best) === String(place) ? "best" : chosen(worst) === String(place) ? "worst" : "";
      return { position: place + 1, clip, rating: Number(chosen(grades[place])), choice };
    });
  return { element: group([...grades, best, worst]), rows };
}

/**
 * @param {Plan} plan
 * @param {Round} round
 * @returns {Questions}
 */
export function unitQuestions({ dimensions, undecided, understood: [understood, most] }, { clips: [a = "", b = ""] }) {
  /** @type {[string, string][]} */
  const options = [["A", "A"], ["B", "B"], [undecided, "undecided"]];
  const asked = dimensions.map((name) => radios(name, `In which is the character more ${name}?`, options));
  const levels = Array.from({ length: most }, (_, index) => /** @type {const} */ ([String(index + 1), UNDERSTANDING[index] ?? ""]));
  const speech = radios(understood, "How much of the speech did you understand?", levels);
  const rows = () => [
    ...dimensions.map((dimension, index) => ({ a, b, dimension, answer: chosen(asked[index]) })),
    { a, b, dimension: understood, answer: chosen(speech) },
  ];
  return { element: group([...asked, speech]), rows };
}

/**
 * @param {Plan} plan
 * @param {Round} round
 * @returns {Questions}
 */
export function preferenceQuestions({ comparison, much }, { clips: [a = "", b = ""] }) {
  const words = ["A much better", "A better", "no preference", "B better", "B much better"];
  const options = words.map((word, index) => /** @type {const} */ ([String(index - much), word]));
  const asked = PREFERRED[comparison === "affect" ? "affect" : "ways"];
  const preferred = radios("preference", asked, options);
  return { element: group([preferred]), rows: () => [{ a, b, preference: Number(chosen(preferred)) }] };
}

const PREFERRED = Object.freeze({
  ways: "In which do the gestures look more natural?",
  affect: "In which does the body feel more as the voice does?",
});

/**
 * Of one clip whose gestures they are, of two whose those of A are.
 *
 * @param {Plan} plan
 * @param {Round} round
 * @returns {Questions}
 */
export function speakerQuestions({ training }, { clips: [clip = "", beside = ""] }) {
  const names = training.map(({ speaker }) => /** @type {const} */ ([speaker, speaker]));
  const asked = beside ? "Both speakers gesture, one in A and the other in B. Who gestures in A?" : "Who gestures like this?";
  const named = radios("speaker", asked, names);
  return { element: group([named]), rows: () => [{ clip, beside, answer: chosen(named) }] };
}

/**
 * Has a form refuse the same clip as the best and the worst.
 *
 * @param {HTMLFieldSetElement} best
 * @param {HTMLFieldSetElement} worst
 */
function notTheSame(best, worst) {
  const check = () => {
    const isSame = chosen(best) !== "" && chosen(best) === chosen(worst);
    const [first] = worst.querySelectorAll("input");
    first?.setCustomValidity(isSame ? "The best cannot be the worst as well." : "");
  };
  best.addEventListener("change", check);
  worst.addEventListener("change", check);
}

/**
 * @param {string} name
 * @param {string} asked
 * @param {readonly (readonly [value: string, text: string])[]} options
 */
function radios(name, asked, options) {
  const inputs = options.map(([value, text]) => {
    const input = el("input", { type: "radio", name, value, required: true });
    return el("label", {}, [input, text]);
  });
  return el("fieldset", {}, [el("legend", {}, [asked]), ...inputs]);
}

/** @param {readonly HTMLElement[]} questions */
function group(questions) {
  return el("fieldset", { "aria-label": "Questions" }, questions);
}

/** @param {HTMLFieldSetElement | undefined} question */
function chosen(question) {
  const input = question?.querySelector("input:checked");
  return input instanceof HTMLInputElement ? input.value : "";
}
