/**
 * A table read (paper §4.1): the lines of a scene one after the other, everybody on his mark, from the folder that a batch
 * wrote. Nothing of it leaves the page but the names of the characters, whose bodies the service makes.
 */

import { choice, el, labelled } from "../dom.js";
import { Bodies } from "../stage/bodies.js";
import { makePlace } from "../stage/scene.js";
import { PROBLEM } from "../state/performed.js";
import { problemOf } from "../service/service.js";
import { VIEW } from "../frame/views.js";
import { CAMERAS, Reading } from "./reading.js";
import { droppedFiles, openedFiles, sceneFiles } from "./scene_files.js";
import { Script } from "./script.js";

/** @import { Place } from "../stage/scene.js" */
/** @import { Service } from "../service/service.js" */
/** @import { Store } from "../state/store.js" */
/** @import { Camera } from "./reading.js" */
/** @import { SceneFiles } from "./scene_files.js" */

/**
 * @param {HTMLElement} element
 * @param {Store} store
 * @param {Service} service
 */
export function mountTableRead(element, store, service) {
  const asked = new URLSearchParams(location.search).get("scene") === "opened";
  const stop = store.watch(VIEW, (view) => {
    if (view === "table_read") {
      queueMicrotask(() => stop());
      const open = mountRoom(element, store, new Bodies(service));
      if (asked) {
        open(openedFiles(service));
      }
    }
  });
  if (asked) {
    store.set(VIEW, "table_read");
  }
}

/**
 * @param {HTMLElement} element
 * @param {Store} store
 * @param {Bodies} bodies
 * @returns {(files: Promise<SceneFiles>) => void} opens a scene
 */
function mountRoom(element, store, bodies) {
  const canvas = el("canvas", { id: "table-read-canvas", tabindex: 0, role: "img", "aria-label": "The scene" });
  const place = makePlace(canvas);
  const room = /** @type {{ reading: Reading | null }} */ ({ reading: null });
  const script = new Script((time_s) => room.reading?.clock.seek(time_s));
  const failed = (/** @type {unknown} */ error) => store.set(PROBLEM, problemOf(error));
  const open = async (/** @type {Promise<SceneFiles>} */ files) => {
    const next = await Reading.open(await files, place, bodies, failed);
    room.reading?.close();
    room.reading = next;
    script.show(next.lines, next.spans);
    store.set(PROBLEM, null);
  };
  const opened = (/** @type {Promise<SceneFiles>} */ files) => void open(files).catch(failed);
  const { controls, tell } = transport(room);
  element.replaceChildren(chooser(opened), el("div", { class: "scene" }, [canvas, script.element]), controls);
  letBeDropped(element, opened);
  store.watch(VIEW, (view) => view === "table_read" || room.reading?.clock.pause());
  keepDrawn(place, () => store.get(VIEW) === "table_read", (now_ms) => {
    tell();
    return showReading(room.reading, { now_ms, script, canvas });
  });
  return opened;
}

/**
 * Shows a scene as it is at a moment; whether that is another picture than before.
 *
 * @param {Reading | null} reading
 * @param {{ now_ms: number, script: Script, canvas: HTMLCanvasElement }} where
 */
function showReading(reading, { now_ms, script, canvas }) {
  if (!reading?.show(now_ms)) {
    return false;
  }
  script.mark(reading.clock.line);
  Object.assign(canvas.dataset, reading.state);
  return true;
}

/**
 * Draws, while it is seen, the frames in which something is other than before.
 *
 * @param {Place} place
 * @param {() => boolean} isSeen
 * @param {(now_ms: number) => boolean} show whether there is something new
 */
function keepDrawn(place, isSeen, show) {
  let isTurned = false;
  place.controls.addEventListener("change", () => (isTurned = true));
  const draw = (/** @type {number} */ now_ms) => {
    if (isSeen()) {
      const isNew = show(now_ms);
      if (place.fit() || isNew || isTurned) {
        place.draw();
      }
      isTurned = false;
    }
    requestAnimationFrame(draw);
  };
  requestAnimationFrame(draw);
}

/** @param {(files: Promise<SceneFiles>) => void} open */
function chooser(open) {
  const folder = el("input", { type: "file", id: "scene-folder", webkitdirectory: true });
  const zip = el("input", { type: "file", id: "scene-zip", accept: ".zip" });
  for (const input of [folder, zip]) {
    input.addEventListener("change", () => open(sceneFiles([...(input.files ?? [])])));
  }
  const told = "Drop the folder of a batch here (understudy batch … --format clip.json --format wav), or choose it:";
  return el("div", { class: "row chooser" }, [el("p", {}, [told]), labelled("Folder", folder), labelled("or a zip of it", zip)]);
}

/**
 * @param {HTMLElement} element
 * @param {(files: Promise<SceneFiles>) => void} open
 */
function letBeDropped(element, open) {
  element.addEventListener("dragover", (event) => event.preventDefault());
  element.addEventListener("drop", (event) => {
    event.preventDefault();
    event.stopPropagation();
    if (event.dataTransfer) {
      open(droppedFiles(event.dataTransfer));
    }
  });
}

/** @param {{ reading: Reading | null }} room */
function transport(room) {
  const play = el("button", { type: "button", id: "scene-play", click: () => room.reading?.clock.toggle() }, ["Play"]);
  const step = (/** @type {number} */ by) => () => {
    const { reading } = room;
    reading?.clock.seek(reading.spans[Math.max(0, reading.clock.line + by)]?.start_s ?? reading.clock.time_s);
  };
  const back = el("button", { type: "button", "aria-label": "One line back", click: step(-1) }, ["◂◂"]);
  const on = el("button", { type: "button", "aria-label": "One line on", click: step(1) }, ["▸▸"]);
  const slider = el("input", { type: "range", min: 0, max: 1, step: 0.01, value: 0, "aria-label": "Time of the scene" });
  slider.addEventListener("input", () => room.reading?.clock.seek(slider.valueAsNumber));
  const time = el("output", { "aria-label": "Time in seconds", id: "scene-time" });
  const camera = choice(CAMERAS, "automatic", (value) => {
    if (room.reading) {
      room.reading.camera = /** @type {Camera} */ (value);
    }
  });
  const tell = () => {
    const { playing = false, time_s = 0, end_s = 0 } = room.reading?.clock ?? {};
    play.textContent = playing ? "Pause" : "Play";
    [slider.max, slider.value] = [String(end_s), String(time_s)];
    time.value = `${time_s.toFixed(1)} s`;
  };
  const controls = el("div", { class: "transport" }, [play, back, on, slider, time, labelled("Camera", camera)]);
  return { controls, tell };
}
