/** What can be changed in the behaviour that is selected: fields for its lexeme, hand, size and marks, and buttons. */

import { choice, el, labelled } from "../dom.js";
import { icon } from "../icons.js";
import { movementName, plain } from "../naming/movements.js";
import { MARKS, PHASE_COLOURS } from "../timeline/phases.js";
import { changeBehavior, editOfSelected, lockBehavior, revertBehavior } from "./behaviors.js";
import { browseGestures } from "./gesture_browser.js";
import { changeOmission } from "./keys.js";
import { putMark } from "./moving.js";
import { replaceGesture } from "./pinning.js";

/** @import { Behavior, BehaviorEdit } from "understudy-client" */
/** @import { Service } from "../service/service.js" */
/** @import { IconName } from "../icons.js" */
/** @import { Store } from "../state/store.js" */
/** @import { Lexemes } from "./lexemes.js" */

const HANDS = /** @type {const} */ ([["left", "Left"], ["right", "Right"], ["both", "Both"]]);
const STEP_S = 0.01;
const HINTS = Object.freeze({ lock: "Keep it whatever else changes (Shift+L)", mute: "Leave it out for now (M)", delete: "Delete it (Delete)" });
/** @type {Readonly<Record<keyof typeof HINTS, IconName>>} */
const SIGNS = Object.freeze({ lock: "lock", mute: "mute", delete: "trash" });

/**
 * The fields of a behaviour.
 *
 * @param {Store} store
 * @param {Service} service
 * @param {Lexemes} lexemes
 * @param {Behavior} behavior
 */
export function inspector(store, service, lexemes, behavior) {
  const fields = behavior.kept ? [what(store, service, lexemes, behavior), marks(store, behavior)] : [];
  return [buttons(store, behavior), ...fields];
}

/**
 * @param {Store} store
 * @param {Service} service
 * @param {Lexemes} lexemes
 * @param {Behavior} behavior
 */
function what(store, service, lexemes, behavior) {
  const { kind, hand, amount } = behavior;
  const fields = [labelled(kind === "gesture" ? "Gesture" : "Movement", lexeme(store, service, lexemes, behavior))];
  if (kind === "gesture") {
    const chosen = (/** @type {string} */ value) =>
      changeBehavior(store, "Hand of", behavior, { hand: /** @type {BehaviorEdit["hand"]} */ (value) });
    fields.push(labelled("Hand", choice(HANDS, hand ?? "right", chosen)));
  }
  if (typeof amount === "number" && kind !== "gaze" && kind !== "posture") {
    const size = el("input", { type: "range", id: "size", min: 0, max: 1, step: 0.05, value: amount });
    size.addEventListener("input", () => changeBehavior(store, "Size of", behavior, { amount: Number(size.value) }));
    fields.push(labelled("Size", size));
  }
  return el("div", { class: "rows" }, fields);
}

/**
 * Gestures are chosen from the browser, everything else from a list.
 *
 * @param {Store} store
 * @param {Service} service
 * @param {Lexemes} lexemes
 * @param {Behavior} behavior
 */
function lexeme(store, service, lexemes, behavior) {
  if (behavior.kind === "gesture") {
    const chosen = (/** @type {string} */ value) => replaceGesture(store, behavior, value);
    const open = () => browseGestures(service, lexemes, { now: behavior.lexeme, chosen });
    return el("button", { type: "button", id: "replace", "aria-haspopup": "dialog", title: `Choose another gesture than ${movementName("gesture", behavior.lexeme)}`, click: open }, ["Replace…"]);
  }
  const names = lexemes.of(behavior.kind);
  const chosen = (/** @type {string} */ value) => changeBehavior(store, "Movement of", behavior, { lexeme: value });
  return choice(names.map((name) => [name, movementName(behavior.kind, name)]), behavior.lexeme, chosen);
}

/**
 * @param {Store} store
 * @param {Behavior} behavior
 */
function marks(store, behavior) {
  const rows = MARKS.flatMap((mark) => {
    const time_s = behavior.sync[mark];
    return time_s === undefined ? [] : [labelled(plain(mark), markField(store, behavior, mark, time_s))];
  });
  return el("fieldset", { class: "marks" }, [el("legend", {}, ["Timing, in seconds"]), ...(behavior.kind === "gesture" ? [legend()] : []), ...rows]);
}

/** Which colours on the timeline and the wrist paths are which part of a gesture. */
function legend() {
  const parts = Object.entries(PHASE_COLOURS).map(([name, colour]) => {
    const sign = el("i", {});
    sign.style.background = colour;
    return el("span", {}, [sign, plain(name)]);
  });
  return el("p", { class: "legend" }, parts);
}

/**
 * @param {Store} store
 * @param {Behavior} behavior
 * @param {string} mark
 * @param {number} time_s
 */
function markField(store, behavior, mark, time_s) {
  const field = el("input", { type: "number", step: STEP_S, min: 0, "data-mark": mark, value: time_s.toFixed(3) });
  field.addEventListener("change", () => {
    if (field.value !== "") {
      putMark(store, behavior, mark, field.valueAsNumber);
    }
  });
  return field;
}

/**
 * @param {Store} store
 * @param {Behavior} behavior
 */
function buttons(store, behavior) {
  const edit = editOfSelected(store);
  const button = (/** @type {"lock" | "mute" | "delete"} */ id, /** @type {() => void} */ click, /** @type {boolean} */ on) =>
    el("button", { type: "button", id, title: HINTS[id], "aria-pressed": String(on), click }, [icon(SIGNS[id]), plain(id)]);
  const isLocked = edit?.lock === true;
  const omission = edit?.omit ?? null;
  const made = behavior.kept
    ? [button("lock", () => lockBehavior(store, behavior, !isLocked), isLocked)]
    : [];
  const omitted = behavior.kept || omission
    ? [
        button("mute", () => changeOmission(store, behavior, "muted"), omission === "muted"),
        button("delete", () => changeOmission(store, behavior, "deleted"), omission === "deleted"),
      ]
    : [];
  const back = edit
    ? [el("button", { type: "button", id: "take-back", title: "Undo all changes to it", click: () => revertBehavior(store, behavior) }, [icon("reset"), "Reset"])]
    : [];
  return el("div", { class: "row", role: "group", "aria-label": "This movement" }, [...made, ...omitted, ...back]);
}
