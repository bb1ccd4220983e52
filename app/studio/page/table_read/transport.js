/** The controls of a table read: play, the lines, the time, the camera, the notes as a file. */

import { choice, el, labelled } from "../dom.js";
import { icon } from "../icons.js";
import { notesText } from "./notes.js";
import { CAMERAS } from "./reading.js";

/** @import { Camera, Reading } from "./reading.js" */

/** Where a scene is read; null before one is open. @typedef {{ reading: Reading | null }} Room */

/**
 * @param {Room} room
 * @param {() => void} openOther
 */
export function transport(room, openOther) {
  const { play, showPlaying } = playButton(room);
  const step = (/** @type {number} */ by) => () => {
    const { reading } = room;
    reading?.clock.seek(reading.spans[Math.max(0, reading.clock.line + by)]?.start_s ?? reading.clock.time_s);
  };
  const back = el("button", { type: "button", class: "square", "aria-label": "One line back", title: "One line back", click: step(-1) }, [icon("step_back")]);
  const on = el("button", { type: "button", class: "square", "aria-label": "One line on", title: "One line on", click: step(1) }, [icon("step_on")]);
  const { slider, time, showTime } = timeSlider(room);
  const camera = choice(CAMERAS, "automatic", (value) => {
    if (room.reading) {
      room.reading.camera = /** @type {Camera} */ (value);
    }
  });
  const tell = () => {
    showPlaying(room.reading?.clock.playing ?? false);
    showTime(room.reading?.clock ?? STOPPED);
  };
  tell();
  const other = el("button", { type: "button", id: "scene-other", click: openOther }, ["Open…"]);
  const controls = el("div", { class: "transport" }, [play, back, on, slider, time, labelled("Camera", camera), notesButton(room), other]);
  return { controls, tell };
}

/** The time before a scene is open. */
const STOPPED = Object.freeze({ time_s: 0, end_s: 0 });

/** @param {Room} room */
function timeSlider(room) {
  const slider = el("input", { type: "range", min: 0, max: 1, step: 0.01, value: 0, "aria-label": "Time of the scene" });
  slider.addEventListener("input", () => room.reading?.clock.seek(slider.valueAsNumber));
  const time = el("output", { "aria-label": "Time in seconds", id: "scene-time" });
  let shown = { time_s: NaN, end_s: NaN };
  const showTime = (/** @type {Readonly<{ time_s: number, end_s: number }>} */ { time_s, end_s }) => {
    if (time_s !== shown.time_s || end_s !== shown.end_s) {
      shown = { time_s, end_s };
      [slider.max, slider.value] = [String(end_s), String(time_s)];
      time.value = `${time_s.toFixed(1)} s`;
    }
  };
  return { slider, time, showTime };
}

/** @param {Room} room */
function playButton(room) {
  const play = el("button", { type: "button", id: "scene-play", class: "primary", click: () => room.reading?.clock.toggle() });
  let shown = /** @type {boolean | null} */ (null);
  const showPlaying = (/** @type {boolean} */ playing) => {
    if (playing !== shown) {
      shown = playing;
      play.replaceChildren(icon(playing ? "pause" : "play"), playing ? "Pause" : "Play");
    }
  };
  return { play, showPlaying };
}

/** @param {Room} room */
function notesButton(room) {
  const save = () => {
    const text = room.reading ? notesText(room.reading.script, room.reading.lines) : "";
    const address = URL.createObjectURL(new Blob([text], { type: "text/plain" }));
    el("a", { href: address, download: "notes.txt" }).click();
    URL.revokeObjectURL(address);
  };
  return el("button", { type: "button", id: "scene-notes", click: save }, ["Save notes"]);
}
