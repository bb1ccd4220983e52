/** The gesture editor (Gesture Engine §4.3): composes a gesture graphically, on the body at once, in the same language. */

import { el } from "../dom.js";
import { VIEW } from "../frame/views.js";
import { askLanguage, keepChecked } from "./checking.js";
import { compass } from "./compass.js";
import { curveForm } from "./curve_form.js";
import { LANGUAGE } from "./gestures.js";
import { handForm } from "./hand_form.js";
import { headerForm } from "./header_form.js";
import { keyTimes } from "./key_times.js";
import { languageText } from "./language_text.js";
import { poseForm } from "./pose_form.js";
import { preview } from "./preview.js";
import { sectorGrid } from "./sector_grid.js";
import { tools } from "./tools.js";
import { trackForm } from "./track_form.js";

/** @import { Service } from "../service/service.js" */
/** @import { Store } from "../state/store.js" */

/**
 * Nothing is asked of the service, and nothing drawn, before the editor is looked at.
 *
 * @param {HTMLElement} element
 * @param {Store} store
 * @param {Service} service
 */
export function mountGestureEditor(element, store, service) {
  let isMounted = false;
  store.watch(VIEW, (view) => {
    if (view === "gesture_editor" && !isMounted) {
      isMounted = true;
      mount(element, store, service);
    } else if (view === "gesture_editor" && !store.get(LANGUAGE)) {
      void askLanguage(store, service);
    }
  });
}

/**
 * @param {HTMLElement} element
 * @param {Store} store
 * @param {Service} service
 */
function mount(element, store, service) {
  const times = el("section", { "aria-label": "Frames" }, [el("h2", {}, ["Frames"]), keyTimes(store)]);
  const frame = el("section", { class: "frame-form", "aria-label": "The frame" }, [
    sectorGrid(store),
    handForm(store),
    compass(store),
    curveForm(store),
    poseForm(store, service),
    trackForm(store),
  ]);
  const whole = headerForm(store);
  const left = el("div", { class: "column body" }, [preview(store, service), times, whole]);
  const right = el("div", { class: "column language" }, [languageText(store, service)]);
  element.append(tools(store, service), left, frame, right);
  void askLanguage(store, service);
  keepChecked(store, service);
}
