/** A round: the clips of one line, each of which has to be seen to its end, then the questions. */

import { el } from "../../studio/page/dom.js";
import { letter } from "./plan.js";
import { modeQuestions, preferenceQuestions, speakerQuestions, unitQuestions } from "./questions.js";

/** @import { Row } from "./answers.js" */
/** @import { Plan, Round } from "./plan.js" */
/** @import { Player } from "./player.js" */

const QUESTIONS = Object.freeze({
  modes: modeQuestions,
  units: unitQuestions,
  ways: preferenceQuestions,
  affect: preferenceQuestions,
  speakers: speakerQuestions,
});

/**
 * Shows each speaker, by his name, until every clip is seen; then resolves.
 *
 * @param {HTMLElement} element
 * @param {Plan} plan
 * @param {Player} player
 * @returns {Promise<void>}
 */
export function mountTraining(element, { training }, player) {
  const next = el("button", { class: "main", disabled: true }, ["Next"]);
  const seen = new Set();
  const problem = el("p", { role: "alert" });
  const clips = training.flatMap(({ clips: [clip = ""] }) => [clip]);
  const [first] = training;
  const saw = (/** @type {string} */ clip) => {
    seen.add(clip);
    next.disabled = seen.size < clips.length;
  };
  const names = training.map(({ speaker }) => `Play ${speaker}`);
  const buttons = first ? playButtons({ ...first, clips }, player, saw, problem, names) : [];
  const told = "Two speakers say the same line. Watch how each of them gestures; then you are asked who is who.";
  return new Promise((resolve) => {
    next.addEventListener("click", () => {
      player.stop();
      resolve();
    });
    element.replaceChildren(el("h1", {}, ["The speakers"]), el("p", {}, [told]), el("div", { class: "row" }, buttons), problem, next);
    buttons[0]?.focus();
  });
}

/**
 * Resolves with the answers.
 *
 * @param {HTMLElement} element
 * @param {Plan} plan
 * @param {Round} round
 * @param {{ player: Player, told: string }} beside
 * @returns {Promise<Row[]>}
 */
export function mountRound(element, plan, round, { player, told }) {
  const questions = QUESTIONS[plan.comparison](plan, round);
  questions.element.disabled = true;
  const hint = el("p", { class: "quiet" }, ["The questions open when you have seen every clip to its end."]);
  const seen = new Set();
  const saw = (/** @type {string} */ clip) => {
    seen.add(clip);
    questions.element.disabled = seen.size < round.clips.length;
    hint.hidden = !questions.element.disabled;
  };
  const problem = el("p", { role: "alert" });
  const names = round.clips.map((_, place) => `Play ${letter(place)}`);
  const buttons = playButtons(round, player, saw, problem, names);
  return new Promise((resolve) => {
    const next = (/** @type {Event} */ event) => {
      event.preventDefault();
      player.stop();
      resolve(questions.rows());
    };
    const form = el("form", { submit: next }, [questions.element, el("button", { class: "main" }, ["Next"])]);
    element.replaceChildren(el("h1", {}, [told]), el("div", { class: "row" }, buttons), problem, hint, form);
    buttons[0]?.focus();
  });
}

/**
 * @param {Round} round
 * @param {Player} player
 * @param {(clip: string) => void} saw
 * @param {HTMLElement} problem
 * @param {readonly string[]} names
 */
function playButtons(round, player, saw, problem, names) {
  const buttons = round.clips.map((clip, place) => {
    const button = el("button", { type: "button", "aria-pressed": "false" }, [names[place] ?? ""]);
    button.addEventListener("click", () => void play(clip, button));
    return button;
  });
  const play = async (/** @type {string} */ clip, /** @type {HTMLButtonElement} */ pressed) => {
    problem.textContent = "";
    try {
      pressed.setAttribute("aria-busy", "true");
      await player.load(round, clip);
      buttons.forEach((button) => button.setAttribute("aria-pressed", String(button === pressed)));
      if (await player.play()) {
        saw(clip);
      }
    } catch (error) {
      problem.textContent = `This clip cannot be played: ${error instanceof Error ? error.message : String(error)}`;
    }
    pressed.removeAttribute("aria-busy");
  };
  return buttons;
}
