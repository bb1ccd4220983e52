/** The offset tracks of the whole gesture: what is added to a joint as the gesture goes. */

import { choice, el, labelled } from "../dom.js";
import { plain } from "../naming/movements.js";
import { redraw } from "../redrawing.js";
import { changeGesture, EDITED, gestureOf, LANGUAGE } from "./gestures.js";
import { tracksOf, withoutTrack, withTrack, withTrackAdded } from "./tracks.js";

/** @import { GestureLanguage, GestureTrack } from "understudy-client" */
/** @import { Store } from "../state/store.js" */

const AXES = /** @type {const} */ (["x", "y", "z"]);

/** @param {Store} store */
export function trackForm(store) {
  const element = el("fieldset", { id: "tracks" });
  const show = () => {
    const language = store.get(LANGUAGE);
    redraw(element, language ? parts(store, language) : []);
  };
  store.watch(EDITED, show);
  store.watch(LANGUAGE, show);
  return element;
}

/**
 * @param {Store} store
 * @param {GestureLanguage} language
 */
function parts(store, language) {
  const click = () => changeGesture(store, "Add an offset track", withTrackAdded);
  return [
    el("legend", {}, ["Offset tracks (whole gesture)"]),
    ...tracksOf(gestureOf(store.get(EDITED))).map((track, index) => trackRow(store, language, track, index)),
    el("button", { type: "button", id: "track-add", click }, ["Add a track"]),
  ];
}

/**
 * @param {Store} store
 * @param {GestureLanguage} language
 * @param {GestureTrack} track
 * @param {number} index
 */
function trackRow(store, language, track, index) {
  const name = `Track ${String(index + 1)}`;
  const change = (/** @type {Partial<GestureTrack>} */ keys) =>
    changeGesture(store, `${name}: ${Object.keys(keys).join()}`, (gesture) => withTrack(language, gesture, index, keys));
  const number = (/** @type {string} */ key, /** @type {string} */ range, /** @type {number} */ value, /** @type {(value: number) => void} */ chosen) => {
    const [min = 0, max = 0] = language.ranges[range] ?? [];
    const field = el("input", { type: "number", min, max, step: "any", value, "data-track": key, "aria-label": `${name}, ${key}` });
    field.addEventListener("change", () => chosen(field.valueAsNumber || 0));
    return labelled(key, field);
  };
  const { degrees, turns = 0, phase_deg = 0 } = track;
  const angles = AXES.map((axis, at) =>
    number(`${axis}, °`, "track_degrees", degrees[at] ?? 0, (angle) => change({ degrees: /** @type {[number, number, number]} */ (degrees.with(at, angle)) })),
  );
  const circling = [
    number("turns", "track_turns", turns, (value) => change({ turns: value })),
    number("from, °", "track_phase_deg", phase_deg, (value) => change({ phase_deg: value })),
  ];
  const remove = () => changeGesture(store, `Remove ${name}`, (gesture) => withoutTrack(gesture, index));
  return el("div", { class: "row track", role: "group", "aria-label": name }, [
    word(`${name}, form`, language.track_forms, track.form, (form) => change({ form })),
    word(`${name}, joint`, language.track_joints, track.joint, (joint) => change({ joint })),
    ...angles,
    ...(track.form === "circling" ? circling : []),
    el("button", { type: "button", "aria-label": `Remove ${name}`, click: remove }, ["Remove"]),
  ]);
}

/**
 * @template {string} Word
 * @param {string} label
 * @param {readonly Word[]} words
 * @param {string} value
 * @param {(word: Word) => void} chosen
 */
function word(label, words, value, chosen) {
  const select = choice(words.map((each) => [each, plain(each)]), value, (each) => chosen(/** @type {Word} */ (each)));
  select.setAttribute("aria-label", label);
  return select;
}
