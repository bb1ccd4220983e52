/** A study: the rater says who he is, sees the clips of one line after the other, answers, and saves his answers. */

import { el } from "../../studio/page/dom.js";
import { Answers } from "./answers.js";
import { mountEnd, saveButton } from "./end.js";
import { keeping } from "./keeping.js";
import { Player } from "./player.js";
import { roundsOf } from "./plan.js";
import { mountRound, mountTraining } from "./round.js";
import { mountStart } from "./start.js";

/** @import { Plan } from "./plan.js" */

const main = /** @type {HTMLElement} */ (document.getElementById("study"));
const plan = /** @type {Plan} */ (JSON.parse(document.getElementById("plan")?.textContent ?? ""));
const kept = keeping();
mountStart(main, plan, kept, (rater) => void rate(rater));

/** @param {number} rater */
async function rate(rater) {
  const rounds = roundsOf(plan, rater);
  const answers = new Answers(plan, rater, kept.store);
  const canvas = el("canvas", { "aria-label": "The character who performs", role: "img" });
  const player = new Player(canvas, plan.comparison === "units" || plan.comparison === "speakers");
  const form = el("section");
  main.replaceChildren(canvas, form, el("footer", { class: "row" }, [saveButton(plan, answers)]));
  if (plan.training.length > 0) {
    await mountTraining(form, plan, player);
  }
  for (const [index, round] of rounds.entries()) {
    if (!answers.has(index)) {
      const told = `Round ${index + 1} of ${rounds.length}`;
      answers.keep(index, await mountRound(form, plan, round, { player, told }));
    }
  }
  player.stop();
  mountEnd(main, plan, answers);
}
