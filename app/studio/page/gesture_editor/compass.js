/** The directions of fingers and palm, to be chosen where they are: those not at a right angle cannot be. */

import { el } from "../dom.js";
import { possibleWrist, withArm } from "./frames.js";
import { ARM, changeGesture, EDITED, FRAME, gestureOf, LANGUAGE } from "./gestures.js";
import { orientationOf, partnersOf } from "./possible.js";
import { redraw } from "../redrawing.js";

/** @import { GestureLanguage } from "understudy-client" */
/** @import { Store } from "../state/store.js" */
/** @import { Wrist } from "./possible.js" */

const LAYERS = /** @type {const} */ ([["Away", 1, "⊗"], ["Level", 0, "·"], ["Towards", -1, "⊙"]]);
const HEIGHTS = [1, 0, -1];
const IN_LINE = "as the forearm";
/** What stands on the directions of a layer, from the upper left on; its middle is in LAYERS. */
const ARROWS = Object.freeze(["↖", "↑", "↗", "←", "", "→", "↙", "↓", "↘"]);

/** @param {Store} store */
export function compass(store) {
  const element = el("fieldset", { id: "wrist" });
  const show = () => {
    const language = store.get(LANGUAGE);
    redraw(element, language ? parts(store, language) : []);
  };
  for (const of of [EDITED, FRAME, ARM, LANGUAGE]) {
    store.watch(/** @type {typeof FRAME} */ (of), show);
  }
  return element;
}

/**
 * @param {Store} store
 * @param {GestureLanguage} language
 */
function parts(store, language) {
  const wrist = gestureOf(store.get(EDITED)).frames[store.get(FRAME)]?.[store.get(ARM)]?.wrist ?? null;
  const open = el("button", { type: "button", id: "wrist-open", disabled: !wrist, click: () => put(store, undefined) }, ["Leave free"]);
  return [
    el("legend", {}, ["Wrist"]),
    half(store, language, wrist, { key: "finger_base", other: "palm", title: "Fingers point" }),
    half(store, language, wrist, { key: "palm", other: "finger_base", title: "Palm faces" }),
    open,
  ];
}

/** @typedef {{ key: "finger_base" | "palm", other: "finger_base" | "palm", title: string }} Half */

/**
 * @param {Store} store
 * @param {GestureLanguage} language
 * @param {Wrist | null} wrist
 * @param {Half} which
 */
function half(store, language, wrist, { key, other, title }) {
  const possible = partnersOf(language, wrist?.[other]);
  const chosen = wrist ? orientationOf(language, wrist[key]) : null;
  const layers = LAYERS.map(([name, away, middle]) => {
    const cells = cellsOf(language, store.get(ARM) === "leading" ? -1 : 1, away);
    const buttons = cells.map((index, at) => {
      const sign = ARROWS[at] || middle;
      return direction(store, language, { index, key, title, sign }, { isChosen: index === chosen, isPossible: possible.has(index) });
    });
    return el("div", { class: "layer", role: "group", "aria-label": name }, [el("span", {}, [name]), ...buttons]);
  });
  return el("div", { class: "compass", role: "group", "aria-label": title }, [el("span", {}, [title]), ...layers]);
}

/**
 * The orientations of a layer, from the upper left on, as seen from before the body: outwards is to the left of the
 * right hand, whose `outwards` is -1, and to the right of the left.
 *
 * @param {GestureLanguage} language
 * @param {number} outwards
 * @param {number} away
 */
function cellsOf({ orientations }, outwards, away) {
  const places = HEIGHTS.flatMap((up) => [-1, 0, 1].map((right) => [right * outwards, up, away]));
  return places.map((place) => orientations.findIndex(({ vector }) => vector.every((part, axis) => part === place[axis])));
}

/**
 * @param {Store} store
 * @param {GestureLanguage} language
 * @param {{ index: number, key: "finger_base" | "palm", title: string, sign: string }} which
 * @param {{ isChosen: boolean, isPossible: boolean }} state
 */
function direction(store, language, { index, key, title, sign }, { isChosen, isPossible }) {
  const directions = language.orientations[index]?.directions ?? [];
  const name = directions.join(" ") || IN_LINE;
  return el("button", {
    type: "button",
    class: "direction",
    "data-direction": directions.join("") || "Default",
    "aria-label": `${title} ${name}`,
    "aria-pressed": String(isChosen),
    title: isPossible ? name : `${name}: not at a right angle`,
    disabled: !isPossible,
    click: () => put(store, { [key]: directions }),
  }, [sign]);
}

/**
 * @param {Store} store
 * @param {Partial<Wrist> | undefined} changed
 */
function put(store, changed) {
  const language = store.get(LANGUAGE);
  const [index, arm] = [store.get(FRAME), store.get(ARM)];
  changeGesture(store, "Direction of the wrist", (gesture) => {
    const before = gesture.frames[index]?.[arm]?.wrist ?? { finger_base: [], palm: [] };
    return withArm(gesture, index, arm, { wrist: changed && language ? possibleWrist(language, before, changed) : undefined });
  });
}
