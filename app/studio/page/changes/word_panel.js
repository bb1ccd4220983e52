/** What can be changed in the word that is selected: its mark, its time, and a movement that is added on it. */

import { choice, el, labelled } from "../dom.js";
import { icon } from "../icons.js";
import { channelName, movementName } from "../naming/movements.js";
import { CHANNELS } from "../timeline/tracks.js";
import { addBehavior } from "./behaviors.js";
import { browseGestures } from "./gesture_browser.js";
import { markWord, timeWord, wordEditOf } from "./words.js";

/** @import { BehaviorEdit, Performance, WordEdit } from "understudy-client" */
/** @import { Service } from "../service/service.js" */
/** @import { Store } from "../state/store.js" */
/** @import { Lexemes } from "./lexemes.js" */

const MARKS = /** @type {const} */ ([["", "Auto"], ["important", "Important"], ["still", "Still"]]);
const STEP_S = 0.01;

/**
 * @param {Store} store
 * @param {Service} service
 * @param {Lexemes} lexemes
 * @param {{ performance: Performance, index: number }} word
 */
export function wordPanel(store, service, lexemes, { performance, index }) {
  const word = performance.words[index];
  if (!word) {
    return [];
  }
  const mark = choice(MARKS, wordEditOf(store, index)?.mark ?? "", (value) =>
    markWord(store, index, /** @type {WordEdit["mark"]} */ (value || null)),
  );
  mark.id = "word-mark";
  const times = [word.start_s, word.end_s].every((time_s) => typeof time_s === "number")
    ? timeFields(store, index, word.start_s ?? 0, word.end_s ?? 0)
    : [];
  return [
    el("div", { class: "rows" }, [labelled("Hands", mark), ...times]),
    adding(store, service, lexemes, index),
  ];
}

/**
 * @param {Store} store
 * @param {number} index
 * @param {number} start_s
 * @param {number} end_s
 */
function timeFields(store, index, start_s, end_s) {
  const field = (/** @type {string} */ id, /** @type {number} */ time_s) =>
    el("input", { type: "number", id, step: STEP_S, min: 0, value: time_s.toFixed(3), change: () => change() });
  const [start, end] = [field("word-start", start_s), field("word-end", end_s)];
  const change = () => {
    if (start.value !== "" && end.value !== "") {
      timeWord(store, index, start.valueAsNumber, end.valueAsNumber);
    }
  };
  return [labelled("Begins, s", start), labelled("Ends, s", end)];
}

/**
 * @param {Store} store
 * @param {Service} service
 * @param {Lexemes} lexemes
 * @param {number} index
 */
function adding(store, service, lexemes, index) {
  const add = (/** @type {BehaviorEdit["add"]} */ channel) => (/** @type {string} */ lexeme) =>
    addBehavior(store, index, channel, lexeme);
  const gesture = el(
    "button",
    { type: "button", id: "add-gesture", "aria-haspopup": "dialog", click: () => browseGestures(service, lexemes, { now: "", chosen: add("gesture") }) },
    [icon("add"), "Add a gesture…"],
  );
  const others = CHANNELS.filter((channel) => channel !== "gesture").map((channel) => {
    const names = lexemes.of(channel).map((name) => /** @type {const} */ ([name, movementName(channel, name)]));
    const made = choice([["", `${channelName(channel)}…`], ...names], "", (lexeme) => lexeme && add(channel)(lexeme));
    made.setAttribute("aria-label", `Add a movement of the ${channel}`);
    return made;
  });
  return el("div", { class: "adding", role: "group", "aria-label": "Add on this word" }, [gesture, ...others]);
}
