/** How the path runs through a frame (tension, continuity, bias), the collarbone, and whether it varies each time. */

import { el, labelled } from "../dom.js";
import { plain } from "../naming/movements.js";
import { withArm, withFrame } from "./frames.js";
import { ARM, changeGesture, EDITED, FRAME, gestureOf } from "./gestures.js";
import { redraw } from "../redrawing.js";

/** @import { Store } from "../state/store.js" */

const CURVES = /** @type {const} */ (["tension", "continuity", "bias"]);

/** @param {Store} store */
export function curveForm(store) {
  const element = el("fieldset", { id: "curve" });
  const show = () => redraw(element, [el("legend", {}, ["Path"]), ...parts(store)]);
  for (const of of [EDITED, FRAME, ARM]) {
    store.watch(/** @type {typeof FRAME} */ (of), show);
  }
  return element;
}

/** @param {Store} store */
function parts(store) {
  const index = store.get(FRAME);
  const name = store.get(ARM);
  const frame = gestureOf(store.get(EDITED)).frames[index];
  const curves = CURVES.map((curve) =>
    number(curve, frame?.[curve] ?? null, (value) =>
      changeGesture(store, `The ${curve} of a frame`, (gesture) => withFrame(gesture, index, { [curve]: value })),
    ),
  );
  const shoulder = number("collarbone", frame?.[name]?.shoulder ?? null, (value) =>
    changeGesture(store, "The collarbone", (gesture) => withArm(gesture, index, name, { shoulder: value ?? undefined })),
  );
  const noise = el("input", { type: "checkbox", id: "noise", checked: frame?.noise ?? false });
  noise.addEventListener("change", () =>
    changeGesture(store, "Noise", (gesture) => withFrame(gesture, index, { noise: noise.checked })),
  );
  return [el("div", { class: "row" }, [...curves, shoulder]), labelled("Vary each time", noise)];
}

/**
 * A number from -1 to 1, or none.
 *
 * @param {string} label
 * @param {number | null} value
 * @param {(value: number | null) => void} chosen
 */
function number(label, value, chosen) {
  const typed = el("input", { type: "number", min: -1, max: 1, step: 0.1, value: value ?? "", placeholder: "Free", id: `curve-${label}` });
  typed.addEventListener("change", () => {
    chosen(typed.value === "" ? null : Math.min(Math.max(Number(typed.value), -1), 1));
  });
  return labelled(plain(label), typed);
}
