/** The key times on a line: each frame is a handle that is dragged, or moved by the arrow keys, between its neighbours. */

import { choice, el, labelled } from "../dom.js";
import { canBeWithout, withFrameBehind, withoutFrame, withTime, withType } from "./frames.js";
import { plain } from "../naming/movements.js";
import { changeGesture, EDITED, FRAME, gestureOf, LANGUAGE } from "./gestures.js";
import { roomBehind, timesAt, typesAt } from "./possible.js";
import { redraw } from "../redrawing.js";

/** @import { GestureFrame } from "understudy-client" */
/** @import { Store } from "../state/store.js" */

const STEP = 0.01;
const KEYS = Object.freeze({ ArrowLeft: -STEP, ArrowDown: -STEP, ArrowRight: STEP, ArrowUp: STEP });

/** @param {Store} store */
export function keyTimes(store) {
  const line = el("div", { class: "key-times", role: "group", "aria-label": "Times of the frames" });
  const bar = el("div", { class: "row" });
  const element = el("div", {}, [line, bar]);
  const show = () => {
    const { frames } = gestureOf(store.get(EDITED));
    const focused = line.contains(document.activeElement);
    line.replaceChildren(...frames.map((frame, index) => handle(store, line, frame, index)));
    redraw(bar, frameControls(store));
    if (focused) {
      /** @type {HTMLElement | undefined} */ (line.children[store.get(FRAME)])?.focus();
    }
  };
  for (const of of [EDITED, FRAME, LANGUAGE]) {
    store.watch(/** @type {typeof FRAME} */ (of), show);
  }
  return element;
}

/**
 * @param {Store} store
 * @param {HTMLElement} line
 * @param {GestureFrame} frame
 * @param {number} index
 */
function handle(store, line, frame, index) {
  const [least, most] = timesAt(gestureOf(store.get(EDITED)).frames, index);
  const made = el("button", {
    type: "button",
    role: "slider",
    class: "key-time",
    "aria-label": `Frame ${String(index + 1)}, ${plain(frame.type).toLowerCase()}`,
    "aria-valuemin": least,
    "aria-valuemax": most,
    "aria-valuenow": frame.time,
    "aria-current": index === store.get(FRAME) ? "true" : "false",
    focus: () => store.set(FRAME, index),
    keydown: (/** @type {KeyboardEvent} */ event) => onKey(store, index, event),
    pointerdown: (/** @type {PointerEvent} */ event) => drag(store, line, index, event),
  });
  made.style.left = `${String(frame.time * 100)}%`;
  made.append(el("span", {}, [plain(frame.type)]));
  return made;
}

/**
 * @param {Store} store
 * @param {number} index
 * @param {KeyboardEvent} event
 */
function onKey(store, index, event) {
  const step = /** @type {Record<string, number>} */ (KEYS)[event.key];
  if (step) {
    event.preventDefault();
    changeGesture(store, `Time of frame ${String(index + 1)}`, (gesture) =>
      withTime(gesture, index, (gesture.frames[index]?.time ?? 0) + step),
    );
  }
}

/**
 * @param {Store} store
 * @param {HTMLElement} line
 * @param {number} index
 * @param {PointerEvent} event
 */
function drag(store, line, index, event) {
  event.preventDefault();
  store.set(FRAME, index);
  const { left, width } = line.getBoundingClientRect();
  const moved = (/** @type {PointerEvent} */ { clientX }) =>
    changeGesture(store, `Time of frame ${String(index + 1)}`, (gesture) => withTime(gesture, index, (clientX - left) / width));
  document.addEventListener("pointermove", moved);
  document.addEventListener("pointerup", () => document.removeEventListener("pointermove", moved), { once: true });
}

/** @param {Store} store */
function frameControls(store) {
  const language = store.get(LANGUAGE);
  const index = store.get(FRAME);
  const { frames } = gestureOf(store.get(EDITED));
  const frame = frames[index];
  if (!language || !frame) {
    return [];
  }
  const types = typesAt(language, frames, index);
  const type = choice(types.map((name) => [name, plain(name)]), frame.type, (chosen) =>
    changeGesture(store, "Type of a frame", (gesture) => withType(language, gesture, index, chosen)),
  );
  type.id = "frame-type";
  return [labelled(`Frame ${String(index + 1)} at ${String(frame.time)}`, type), add(store, index), remove(store, index)];
}

/**
 * @param {Store} store
 * @param {number} index
 */
function add(store, index) {
  const language = store.get(LANGUAGE);
  const add = () => {
    if (language) {
      changeGesture(store, "Add a frame", (gesture) => withFrameBehind(language, gesture, index));
      store.set(FRAME, index + 1);
    }
  };
  const isFull = !language || !roomBehind(language, gestureOf(store.get(EDITED)).frames, index);
  return el("button", { type: "button", id: "frame-add", disabled: isFull, click: add }, ["Add a frame after it"]);
}

/**
 * @param {Store} store
 * @param {number} index
 */
function remove(store, index) {
  const remove = () => {
    store.set(FRAME, Math.max(index - 1, 0));
    changeGesture(store, "Remove a frame", (gesture) => withoutFrame(gesture, index));
  };
  const isNeeded = !canBeWithout(gestureOf(store.get(EDITED)).frames, index);
  return el("button", { type: "button", id: "frame-remove", disabled: isNeeded, click: remove }, ["Remove this frame"]);
}
