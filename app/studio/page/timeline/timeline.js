/**
 * The timeline: rows of what is heard, meant and done, in time, with the playhead. Clicking selects (SELECTION); see
 * pointing.js for what dragging does, and how others hook in.
 */

import { el } from "../dom.js";
import { icon } from "../icons.js";
import { problemOf } from "../service/service.js";
import { PERFORMED, PROBLEM } from "../state/performed.js";
import { isRecorded, PROJECT } from "../state/project.js";
import { OTHERS } from "./compared.js";
import { makeList } from "./list.js";
import { keepLooks, LOOKS, toggleLook } from "./looks.js";
import { PEAKS, peaksOf } from "./signals.js";
import { Timeline, ZOOM } from "./view.js";

/** @import { IconName } from "../icons.js" */
/** @import { Store } from "../state/store.js" */

/**
 * @param {HTMLElement} element
 * @param {Store} store
 */
export function mountTimeline(element, store) {
  const canvas = el("canvas", { id: "timeline-canvas", "aria-label": "Timeline; the list beside it says the same", role: "img" });
  const playhead = el("div", { class: "playhead" });
  const { list, show } = makeList(store);
  const timeline = new Timeline(canvas, playhead, store);
  const none = el("p", { class: "none quiet" }, ["The timeline appears when the line is performed."]);
  const screen = el("div", { class: "tracks", role: "group", tabindex: 0, "aria-label": "Tracks" }, [canvas, timeline.gutter.element, playhead, none]);
  element.append(toolbar(timeline, store), el("div", { class: "beside" }, [screen, list]));
  keepLooks(store);
  for (const of of [PERFORMED, LOOKS, OTHERS]) {
    store.watch(/** @type {typeof LOOKS} */ (of), () => show(timeline.take()));
  }
  store.watch(PERFORMED, (line) => (none.hidden = line !== null));
  store.watch(LOOKS, (looks) => (list.hidden = !looks.list));
  keepPeaks(store);
  new ResizeObserver(() => timeline.draw()).observe(screen);
  new MutationObserver(() => timeline.draw()).observe(document.documentElement, { attributeFilter: ["data-theme"] });
}

/**
 * @param {Timeline} timeline
 * @param {Store} store
 */
function toolbar(timeline, store) {
  const button = (/** @type {string} */ name, /** @type {IconName} */ sign, /** @type {() => void} */ click) =>
    el("button", { type: "button", class: "square quiet", "aria-label": name, title: name, click }, [icon(sign)]);
  return el("div", { class: "toolbar", role: "toolbar", "aria-label": "Timeline" }, [
    button("Zoom in", "zoom_in", () => timeline.zoom(1 / ZOOM)),
    button("Zoom out", "zoom_out", () => timeline.zoom(ZOOM)),
    button("Whole line", "whole", () => timeline.whole()),
    button("Earlier", "earlier", () => timeline.scroll(-0.5)),
    button("Later", "later", () => timeline.scroll(0.5)),
    button("Zoom to the selection", "selection", () => timeline.selection()),
    toggle(store, { name: "ripple", sign: "ripple" }, "Ripple", "What comes later in a row moves along (R)"),
    toggle(store, { name: "alternatives", sign: "alternatives" }, "Alternatives", "What could have been done as well, and why it was not"),
    toggle(store, { name: "list", sign: "list" }, "List", "Everything on the timeline as a list"),
  ]);
}

/**
 * Decodes each new recording for its wave, once the service has taken it.
 *
 * @param {Store} store
 */
function keepPeaks(store) {
  /** @type {File | null} */
  let file = null;
  store.watch(PERFORMED, (line) => {
    const { audio } = store.get(PROJECT);
    if (line && audio && audio !== file) {
      file = audio;
      const decoded = isRecorded(audio) ? peaksOf(audio) : Promise.resolve(new Float32Array());
      decoded.then(
        (peaks) => store.set(PEAKS, peaks),
        (error) => {
          store.set(PEAKS, new Float32Array());
          store.set(PROBLEM, { ...problemOf(error), detail: `${audio.name}: the browser cannot decode it, nor play it` });
        },
      );
    }
  });
}

/**
 * @param {Store} store
 * @param {{ name: "alternatives" | "list" | "ripple", sign: IconName }} which
 * @param {string} text
 * @param {string} title
 */
function toggle(store, { name, sign }, text, title) {
  const button = el("button", { type: "button", id: name, title, class: name === "ripple" ? "quiet apart" : "quiet" }, [icon(sign), text]);
  button.addEventListener("click", () => toggleLook(store, name));
  store.watch(LOOKS, (looks) => button.setAttribute("aria-pressed", String(looks[name])));
  return button;
}
