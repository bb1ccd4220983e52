/** The page: puts the figures on the stage and asks what the player asks. */

import { answer } from "./conversation.js";
import { fetched } from "./fetching.js";
import { loadedFigure } from "./figure.js";
import { makeStage } from "./stage.js";

/** @import { Dialogue, Line } from "../server/dialogue.js" */
/** @import { Figures } from "./conversation.js" */

const MOST_REASONS = 6;

/**
 * @template {Element} Kind
 * @param {string} selector
 * @param {new () => Kind} kind
 */
function element(selector, kind) {
  const found = document.querySelector(selector);
  if (!(found instanceof kind)) {
    throw new Error(`the page has no ${selector}`);
  }
  return found;
}

const said = element("#said", HTMLElement);
const voice = element("#voice", HTMLAudioElement);
const reasons = element("#reasons", HTMLElement);

/** @param {string} reason */
function tell(reason) {
  const row = document.createElement("li");
  row.textContent = reason;
  reasons.append(row);
  while (reasons.children.length > MOST_REASONS) {
    reasons.firstElementChild?.remove();
  }
}

/**
 * @param {Line} line
 * @param {string} speaker
 * @param {Figures} figures
 */
async function ask(line, speaker, figures) {
  const buttons = document.querySelectorAll("button");
  buttons.forEach((button) => (button.disabled = true));
  reasons.replaceChildren();
  said.textContent = "…";
  try {
    const spoken = answer(line, figures, voice, tell);
    said.textContent = `${speaker}: ${line.text}`;
    await spoken;
  } catch (error) {
    said.textContent = String(error);
  }
  buttons.forEach((button) => (button.disabled = false));
}

/** @type {Figures | undefined} */
let figures;
const dialogue = /** @type {Dialogue} */ (await fetched("/dialogue.json"));
const scene = makeStage(element("canvas", HTMLCanvasElement), dialogue.player.place, () => {
  figures?.speaker.performer.update();
  figures?.listener.performer.update();
});
const [speaker, listener] = await Promise.all([
  loadedFigure("speaker", dialogue.speaker, scene),
  loadedFigure("listener", dialogue.listener, scene),
]);
figures = { speaker, listener };
// For tests, and for whoever looks around in the console.
Object.assign(globalThis, { figures });

for (const line of dialogue.lines) {
  const button = document.createElement("button");
  button.textContent = line.question;
  button.addEventListener("click", () => void ask(line, dialogue.speaker.name, { speaker, listener }));
  element("#questions", HTMLElement).append(button);
}
said.textContent = `Ask ${dialogue.speaker.name} something; ${dialogue.listener.name} is listening.`;
