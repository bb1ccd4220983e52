/** A round: the clips of one line, each of which has to be seen to its end, then the questions. */

import { el } from "../../studio/page/dom.js";
import { letter } from "./plan.js";
import { modeQuestions, unitQuestions } from "./questions.js";

/** @import { Row } from "./answers.js" */
/** @import { Plan, Round } from "./plan.js" */
/** @import { Player } from "./player.js" */

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
  const questions = plan.comparison === "modes" ? modeQuestions(plan, round) : unitQuestions(plan, round);
  questions.element.disabled = true;
  const hint = el("p", { class: "quiet" }, ["The questions open when you have seen every clip to its end."]);
  const seen = new Set();
  const saw = (/** @type {string} */ clip) => {
    seen.add(clip);
    questions.element.disabled = seen.size < round.clips.length;
    hint.hidden = !questions.element.disabled;
  };
  const problem = el("p", { role: "alert" });
  const buttons = playButtons(round, player, saw, problem);
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
 */
function playButtons(round, player, saw, problem) {
  const buttons = round.clips.map((clip, place) => {
    const button = el("button", { type: "button", "aria-pressed": "false" }, [`Play ${letter(place)}`]);
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
