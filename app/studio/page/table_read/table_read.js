/**
 * A table read (paper §4.1): the lines of a scene one after the other, everybody on his mark, from the folder that a batch
 * wrote. Nothing of it leaves the page but the names of the characters, whose bodies the service makes.
 */

import { el } from "../dom.js";
import { open as openLine } from "../line/opening.js";
import { Bodies } from "../stage/bodies.js";
import { makePlace } from "../stage/scene.js";
import { followTheme } from "../stage/theme.js";
import { PROBLEM } from "../state/performed.js";
import { problemOf } from "../service/service.js";
import { VIEW } from "../frame/views.js";
import { Reading } from "./reading.js";
import { chooser } from "./chooser.js";
import { droppedFiles, openedFiles } from "./scene_files.js";
import { Script } from "./script.js";
import { transport } from "./transport.js";

/** @import { Place } from "../stage/scene.js" */
/** @import { Service } from "../service/service.js" */
/** @import { Store } from "../state/store.js" */
/** @import { SceneFiles } from "./scene_files.js" */
/** @import { SceneLine } from "./scene_index.js" */
/** @import { Room } from "./transport.js" */

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
}

/**
 * @param {HTMLElement} element
 * @param {Store} store
 * @param {Bodies} bodies
 * @returns {(files: Promise<SceneFiles>) => void} opens a scene
 */
function mountRoom(element, store, bodies) {
  const canvas = el("canvas", { id: "table-read-canvas", tabindex: 0, role: "img", "aria-label": "The scene" });
  const place = makePlace(canvas, store);
  const room = /** @type {Room} */ ({ reading: null });
  const script = scriptOf(store, room);
  const failed = (/** @type {unknown} */ error) => store.set(PROBLEM, problemOf(error));
  const open = async (/** @type {Promise<SceneFiles>} */ files) => {
    const next = await Reading.open(await files, place, bodies, failed);
    room.reading?.close();
    room.reading = next;
    script.show({ ...next, cast: [...next.marks.keys()] });
    element.classList.remove("empty");
    store.set(PROBLEM, null);
  };
  const opened = (/** @type {Promise<SceneFiles>} */ files) => void open(files).catch(failed);
  const { controls, tell } = transport(room, () => element.classList.toggle("empty"));
  element.classList.add("empty");
  element.replaceChildren(chooser(opened), el("div", { class: "scene" }, [canvas, script.element]), controls);
  letBeDropped(element, opened);
  store.watch(VIEW, (view) => view === "table_read" || room.reading?.clock.pause());
  followTheme(place, () => place.draw());
  keepDrawn(place, () => store.get(VIEW) === "table_read", (now_ms) => {
    tell();
    return showReading(room.reading, { now_ms, script, canvas });
  });
  return opened;
}

/**
 * The script whose lines move the clock of the room.
 *
 * @param {Store} store
 * @param {Room} room
 */
function scriptOf(store, room) {
  return new Script({
    seek: (time_s) => room.reading?.clock.seek(time_s),
    play: (time_s) => room.reading?.clock.playFrom(time_s),
    open: (line) => toStudio(store, room, line),
  });
}

/**
 * Opens a line of the scene as a line of its own: its recording, its words, who plays it.
 *
 * @param {Store} store
 * @param {Room} room
 * @param {SceneLine} line
 */
function toStudio(store, { reading }, { id, sound, text, performer }) {
  const recording = reading?.files.get(sound);
  if (recording) {
    const audio = new File([recording], sound.split("/").at(-1) ?? id, { type: recording.type });
    openLine(store, { audio, text, options: performer === "default" ? {} : { character: performer } }, { isFound: true });
    store.set(VIEW, "line");
  }
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
