/** A question and its answer: the recording, the speaker and the listener in time with it, and why the speaker moves. */

import { clipFromJson } from "understudy-client";

import { fetched } from "./fetching.js";

/** @import { ClipEvent } from "understudy-client" */
/** @import { Line } from "../server/dialogue.js" */
/** @import { PerformedLine } from "../server/performances.js" */
/** @import { Figure } from "./figure.js" */

/** @typedef {{ speaker: Figure, listener: Figure }} Figures */

/**
 * Plays the answer to a line; resolves when it has been spoken.
 *
 * @param {Line} line
 * @param {Figures} figures
 * @param {HTMLAudioElement} voice
 * @param {(reason: string) => void} tell called as each behaviour begins
 */
export async function answer({ id }, { speaker, listener }, voice, tell) {
  const performed = /** @type {PerformedLine} */ (await fetched(`/performances/${id}.json`));
  voice.src = `/lines/${id}.flac`;
  const clock = () => voice.currentTime;
  const ended = new Promise((resolve) => voice.addEventListener("ended", resolve, { once: true }));
  await voice.play();
  speaker.performer.play(clipFromJson(performed.speaker), { clock, onEvent: reasons(performed, tell) });
  listener.performer.play(clipFromJson(performed.listener), { clock });
  await ended;
  speaker.performer.stop();
  listener.performer.stop();
}

/**
 * Tells why a behaviour is there when it starts.
 *
 * @param {PerformedLine} performed
 * @param {(reason: string) => void} tell
 * @returns {(event: ClipEvent) => void}
 */
function reasons({ behaviors }, tell) {
  const byId = new Map(behaviors.map((behavior) => [behavior.id, behavior]));
  return ({ behavior, point }) => {
    const found = byId.get(behavior);
    if (found && point === "start") {
      tell(`${found.kind} ${found.lexeme} ← ${found.rule ?? "by itself"}`);
    }
  };
}
