/** What holds for the whole gesture: its name, what it shows, how long it takes, whose arms, at which agitation. */

import { choice, el, labelled } from "../dom.js";
import { AGITATION, plain } from "../naming/movements.js";
import { EITHER, withArms } from "./arms.js";
import { ARM, changeGesture, EDITED, FRAME, gestureOf, LANGUAGE } from "./gestures.js";
import { redraw } from "../redrawing.js";

/** @import { GestureValues } from "understudy-client" */
/** @import { Store } from "../state/store.js" */
/** @import { Edited } from "./gestures.js" */

const FACTORS = /** @type {const} */ (["amplitude", "tempo", "fluidity", "power", "repetition"]);

/** @param {Store} store */
export function headerForm(store) {
  const element = el("fieldset", { id: "gesture-header" });
  const show = () => {
    const gesture = gestureOf(store.get(EDITED));
    const isOpen = element.querySelector("details")?.open ?? false;
    const parts = [which(store), texts(store, gesture), arms(store, gesture), levels(store, gesture, isOpen)];
    redraw(element, [el("legend", {}, ["Gesture"]), ...parts]);
  };
  store.watch(EDITED, show);
  store.watch(LANGUAGE, show);
  return element;
}

/**
 * Which of several gestures of a file is edited.
 *
 * @param {Store} store
 */
function which(store) {
  const { gestures, index } = store.get(EDITED);
  const names = /** @type {[string, string][]} */ (gestures.map(({ name }, at) => [String(at), name]));
  const select = choice(names, String(index), (chosen) => {
    store.set(FRAME, 0);
    store.set(ARM, "leading");
    store.set(EDITED, /** @type {Edited} */ ({ gestures, index: Number(chosen) }));
  });
  const made = labelled("Of this file", select);
  made.hidden = gestures.length < 2;
  return made;
}

/**
 * @param {Store} store
 * @param {GestureValues} gesture
 */
function texts(store, gesture) {
  const name = text("Name", "gesture-name", gesture.name, (value) => put(store, "Name", { name: value }));
  const kind = text("Kind", "gesture-class", gesture.class, (value) => put(store, "Class", { class: value }));
  const shows = text("Stands for", "gesture-categories", gesture.categories.join(" "), (value) =>
    put(store, "Lexemes", { categories: value.toUpperCase().split(/\s+/).filter(Boolean) }),
  );
  shows.title = "What rules and BML ask for when they want it, in capitals with spaces between (its lexemes): NEGATION STOP";
  const [least, most] = store.get(LANGUAGE)?.ranges["duration_s"] ?? [0.1, 10];
  const lasts = el("input", { type: "number", id: "gesture-duration", min: least, max: most, step: 0.1, value: gesture.duration_s });
  lasts.addEventListener("change", () => put(store, "Duration", { duration_s: Math.min(Math.max(Number(lasts.value), least), most) }));
  return el("div", { class: "row" }, [name, kind, shows, labelled("Duration, s", lasts)]);
}

/**
 * @param {Store} store
 * @param {GestureValues} gesture
 */
function arms(store, gesture) {
  const made = choice(
    [[EITHER, "Either"], ["left", "Left"], ["right", "Right"], ["both", "Both"]],
    gesture.arms ?? EITHER,
    (value) => {
      store.set(ARM, "leading");
      changeGesture(store, "Arms", (now) => withArms(now, value));
    },
  );
  made.id = "gesture-arms";
  const aimed = el("input", { type: "checkbox", checked: gesture.aimed ?? false });
  aimed.addEventListener("change", () => put(store, "Aim", { aimed: aimed.checked }));
  const shown = choice([["leading", "Right (leading)"], ["other", "Left"]], store.get(ARM), (value) =>
    store.set(ARM, /** @type {"leading" | "other"} */ (value)),
  );
  shown.id = "gesture-arm";
  shown.disabled = gesture.arms !== "both";
  return el("div", { class: "row" }, [labelled("Arms", made), labelled("Shown arm", shown), labelled("Points at a target", aimed)]);
}

/**
 * @param {Store} store
 * @param {GestureValues} gesture
 * @param {boolean} isOpen
 */
function levels(store, gesture, isOpen) {
  const rows = AGITATION.map(([level, called]) => {
    const values = gesture.levels[level];
    const fits = el("input", { type: "checkbox", checked: Boolean(values), "aria-label": `Suits ${called.toLowerCase()} lines` });
    fits.disabled = Boolean(values) && Object.keys(gesture.levels).length === 1;
    fits.addEventListener("change", () => put(store, "Agitation", { levels: withLevel(gesture.levels, level, fits.checked) }));
    const factors = FACTORS.map((factor) => el("td", {}, [values ? factorInput(store, gesture, level, factor) : ""]));
    return el("tr", {}, [el("td", {}, [fits]), el("th", { scope: "row" }, [called]), ...factors]);
  });
  const head = el("tr", {}, ["suits", "agitation", ...FACTORS].map((name) => el("th", { scope: "col" }, [plain(name)])));
  return el("details", { open: isOpen }, [el("summary", {}, ["Agitation and expressivity"]), el("table", {}, [head, ...rows])]);
}

/**
 * @param {GestureValues["levels"]} levels
 * @param {string} level
 * @param {boolean} fits
 */
function withLevel(levels, level, fits) {
  const usual = levels["medium"] ?? Object.values(levels)[0];
  const kept = Object.entries(levels).filter(([name]) => name !== level);
  return Object.fromEntries(fits && usual ? [...kept, [level, usual]] : kept);
}

/**
 * @param {Store} store
 * @param {GestureValues} gesture
 * @param {string} level
 * @param {typeof FACTORS[number]} factor
 */
function factorInput(store, gesture, level, factor) {
  const [least, most] = store.get(LANGUAGE)?.ranges[factor] ?? [0, 3];
  const values = gesture.levels[level];
  const typed = el("input", { type: "number", min: least, max: most, step: 0.05, value: values?.[factor] ?? 0, "aria-label": `${factor} at ${level} agitation` });
  typed.addEventListener("change", () => {
    const changed = { ...values, [factor]: Math.min(Math.max(Number(typed.value), least), most) };
    put(store, "Expressivity", { levels: /** @type {GestureValues["levels"]} */ ({ ...gesture.levels, [level]: changed }) });
  });
  return typed;
}

/**
 * @param {string} label
 * @param {string} id
 * @param {string} value
 * @param {(value: string) => void} chosen
 */
function text(label, id, value, chosen) {
  const typed = el("input", { id, value, spellcheck: false, autocomplete: "off" });
  typed.addEventListener("change", () => chosen(typed.value));
  return labelled(label, typed);
}

/**
 * @param {Store} store
 * @param {string} label
 * @param {Partial<GestureValues>} keys
 */
function put(store, label, keys) {
  changeGesture(store, label, (gesture) => ({ ...gesture, ...keys }));
}
