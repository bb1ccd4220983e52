/** The controls of the stage: play, step, speed, loop, shot, listener, trail; their keys are in playing_keys.js. */

import { choice, el, labelled } from "../dom.js";
import { icon } from "../icons.js";
import { ChangeProject } from "../state/change_project.js";
import { PERFORMED, PLAYBACK, TIME_S } from "../state/performed.js";
import { PROJECT } from "../state/project.js";
import { SHOTS } from "./cameras.js";
import { keepQuality, keptQuality, QUALITIES, QUALITY } from "./detail.js";
import { FRAME_S, followPlayingKeys, pauseWhereUnseen, stepBy, togglePlaying, wholeLine } from "./playing_keys.js";
import { LISTENER, VIEWING } from "./viewing.js";

/** @import { Store } from "../state/store.js" */
/** @import { Shot } from "./cameras.js" */
/** @import { Quality } from "./detail.js" */
/** @import { Listening } from "./viewing.js" */

const QUALITY_TITLE = "Automatic draws everything where that is quick; where it is not, what moves is coarser and all is drawn at rest";
const SPEEDS = ["0.25", "0.5", "1", "1.5", "2"];

/**
 * @param {HTMLElement} element
 * @param {Store} store
 */
export function mountTransport(element, store) {
  store.set(QUALITY, keptQuality());
  element.append(playButton(store), ...stepButtons(store), clockFace(store), loopButton(store), ...choices(store));
  followPlayingKeys(store);
  pauseWhereUnseen(store);
}

/** @param {Store} store */
function playButton(store) {
  const button = el("button", { type: "button", id: "play", class: "primary", title: "Play or pause (Space)", click: () => togglePlaying(store) });
  store.watch(PLAYBACK, ({ playing }) => button.replaceChildren(icon(playing ? "pause" : "play"), playing ? "Pause" : "Play"));
  store.watch(PERFORMED, (line) => (button.disabled = line === null));
  return button;
}

/** @param {Store} store */
function stepButtons(store) {
  const step = (/** @type {number} */ frames) => () => stepBy(store, frames * FRAME_S);
  return [
    el("button", { type: "button", class: "square step", "aria-label": "One frame back", title: "One frame back (←)", click: step(-1) }, [icon("step_back")]),
    el("button", { type: "button", class: "square step", "aria-label": "One frame on", title: "One frame on (→)", click: step(1) }, [icon("step_on")]),
  ];
}

/** @param {Store} store */
function clockFace(store) {
  const face = el("output", { id: "time", "aria-label": "Time in seconds" });
  store.watch(TIME_S, (time_s) => (face.value = `${time_s.toFixed(2)} s`));
  return face;
}

/** @param {Store} store */
function loopButton(store) {
  const button = el("button", { type: "button", id: "loop", class: "square", "aria-label": "Loop", title: "Loop: drag over the words to choose what is repeated, or press I and O where it begins and ends" }, [icon("loop")]);
  button.addEventListener("click", () => store.patch(PLAYBACK, { loop: store.get(PLAYBACK).loop ? null : wholeLine(store) }));
  store.watch(PLAYBACK, ({ loop }) => button.setAttribute("aria-pressed", String(loop !== null)));
  return button;
}

/** @param {Store} store */
function choices(store) {
  const speed = choice(SPEEDS.map((each) => [each, `× ${each}`]), "1", (value) => store.patch(PLAYBACK, { speed: Number(value) }));
  const shot = choice(SHOTS, store.get(VIEWING).shot, (value) => store.patch(VIEWING, { shot: /** @type {Shot} */ (value) }));
  const listening = choice(
    [["none", "No listener"], ["beside", "Opposite"], ["instead", "Listener only"]],
    store.get(VIEWING).listening,
    (value) => showListener(store, /** @type {Listening} */ (value)),
  );
  store.watch(VIEWING, (viewing) => ([shot.value, listening.value] = [viewing.shot, viewing.listening]));
  store.watch(PLAYBACK, (playback) => (speed.value = String(Math.abs(playback.speed))));
  [speed.id, shot.id, listening.id] = ["speed", "shot", "listening"];
  const quality = choice(QUALITIES, store.get(QUALITY), (value) => keepQuality(store, /** @type {Quality} */ (value)));
  quality.id = "quality";
  quality.title = QUALITY_TITLE;
  const drawn = [drawing(store, "trail", "Wrist paths"), drawing(store, "onion", "Onion skin"), drawing(store, "safe", "Safe frame"), labelled("Speed", speed), labelled("Quality", quality)];
  const menu = el("details", { class: "menu" }, [el("summary", {}, ["View"]), el("div", { class: "floating" }, drawn)]);
  document.addEventListener("pointerdown", ({ target }) => target instanceof Node && !menu.contains(target) && (menu.open = false));
  menu.addEventListener("keydown", ({ key }) => key === "Escape" && (menu.open = false));
  return [labelled("Camera", shot), labelled("Listener", listening), menu];
}

/**
 * Whether something is drawn on the stage beside who stands there.
 *
 * @param {Store} store
 * @param {"trail" | "onion" | "safe"} id
 * @param {string} name
 */
function drawing(store, id, name) {
  const box = el("input", { type: "checkbox", id });
  box.addEventListener("change", () => store.patch(VIEWING, { [id]: box.checked }));
  store.watch(VIEWING, (viewing) => (box.checked = viewing[id]));
  return labelled(name, box);
}

/**
 * Has somebody listen if nobody does, and shows it.
 *
 * @param {Store} store
 * @param {Listening} listening
 */
function showListener(store, listening) {
  const { options } = store.get(PROJECT);
  store.patch(VIEWING, { listening });
  const wanted = listening === "none" ? [] : [LISTENER];
  if (String(options.listener ?? []) !== String(wanted)) {
    const changed = { options: { ...options, listener: wanted } };
    store.history.execute(new ChangeProject(store, "Listener", changed));
  }
}
