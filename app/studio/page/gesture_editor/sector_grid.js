/** The place of the wrist: McNeill's sectors as a grid on the body, three distances, and an offset from the centre. */

import { el, labelled } from "../dom.js";
import { body } from "./body_outline.js";
import { withArm } from "./frames.js";
import { ARM, changeGesture, EDITED, FRAME, gestureOf, LANGUAGE } from "./gestures.js";
import { isWithinReach } from "./possible.js";
import { redraw } from "../redrawing.js";
import { columns, rows, sectorName } from "./sector_places.js";

/** @import { GestureLanguage } from "understudy-client" */
/** @import { Store } from "../state/store.js" */
/** @import { Place } from "./possible.js" */

/** @type {Readonly<Record<string, string>>} */
const DISTANCES = Object.freeze({ ZNear: "Near", ZMiddle: "Middle", ZFar: "Far" });
const AXES = /** @type {const} */ (["out", "up", "away"]);
/** @type {Place} */
const CENTRE = { x: "XC", y: "YCC", z: "ZMiddle" };

/** @param {Store} store */
export function sectorGrid(store) {
  const element = el("fieldset", { id: "sectors" });
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
  const place = gestureOf(store.get(EDITED)).frames[store.get(FRAME)]?.[store.get(ARM)]?.place ?? null;
  const isFirst = store.get(FRAME) === 0 && store.get(ARM) === "leading";
  const open = el("button", { type: "button", id: "place-open", disabled: isFirst || !place, click: () => put(store, null) }, ["Leave free"]);
  const distances = language.z.map(({ name }) => distance(store, language, place, name));
  return [
    el("legend", {}, ["Place of the wrist"]),
    grid(store, language, place),
    el("div", { class: "row", role: "group", "aria-label": "Distance from the body" }, [...distances, open]),
    offsets(store, place),
  ];
}

/**
 * @param {Store} store
 * @param {GestureLanguage} language
 * @param {Place | null} place
 */
function grid(store, language, place) {
  const side = store.get(ARM) === "leading" ? "right" : "left";
  const made = el("div", { class: "sectors", role: "group", "aria-label": `Sectors as seen from before the body, ${side} hand` }, [body()]);
  for (const row of rows(language)) {
    for (const column of columns(language, side)) {
      const there = /** @type {Place} */ ({ ...(place ?? CENTRE), x: column.name, y: row.name });
      const button = sector(store, language, there, place?.x === column.name && place.y === row.name);
      button.style.left = percent(column.from);
      button.style.width = percent(column.to - column.from);
      button.style.top = percent(row.from);
      button.style.height = percent(row.to - row.from);
      made.append(button);
    }
  }
  return made;
}

/**
 * @param {Store} store
 * @param {GestureLanguage} language
 * @param {Place} there
 * @param {boolean} isHere
 */
function sector(store, language, there, isHere) {
  const name = `${there.x} ${there.y}`;
  const title = `${sectorName(there)} (${name})`;
  return el("button", {
    type: "button",
    class: "sector",
    "data-sector": name,
    "aria-label": sectorName(there),
    "aria-pressed": String(isHere),
    title: isWithinReach(language, there) ? title : `${title}: out of the arm's reach`,
    disabled: !isHere && !isWithinReach(language, there),
    click: () => put(store, there),
  });
}

/**
 * @param {Store} store
 * @param {GestureLanguage} language
 * @param {Place | null} place
 * @param {string} name
 */
function distance(store, language, place, name) {
  const there = /** @type {Place} */ ({ ...(place ?? CENTRE), z: name });
  const isHere = place?.z === name;
  const attributes = {
    type: "button",
    "data-distance": name,
    "aria-pressed": String(isHere),
    disabled: !isHere && !isWithinReach(language, there),
    click: () => put(store, there),
  };
  return el("button", attributes, [DISTANCES[name] ?? name]);
}

/**
 * @param {Store} store
 * @param {Place | null} place
 */
function offsets(store, place) {
  const offset = place?.offset_m ?? [0, 0, 0];
  const [least, most] = store.get(LANGUAGE)?.ranges["offset_m"] ?? [0, 0];
  const inputs = AXES.map((axis, index) => {
    const typed = el("input", { type: "number", min: least, max: most, step: 0.01, value: offset[index] ?? 0, disabled: !place });
    typed.addEventListener("change", () => {
      const metres = Math.min(Math.max(Number(typed.value), least), most);
      const next = /** @type {[number, number, number]} */ (offset.with(index, metres));
      put(store, place && { ...place, offset_m: next });
    });
    return labelled(`Offset ${axis}, m`, typed);
  });
  return el("div", { class: "row" }, inputs);
}

/**
 * @param {Store} store
 * @param {Place | null} place
 */
function put(store, place) {
  const where = place ? `${place.x} ${place.y} ${place.z}` : "open";
  changeGesture(store, `Wrist at ${where}`, (gesture) => withArm(gesture, store.get(FRAME), store.get(ARM), { place: place ?? undefined }));
}

/** @param {number} share */
function percent(share) {
  return `${String(share * 100)}%`;
}
