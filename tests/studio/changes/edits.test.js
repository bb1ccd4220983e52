import assert from "node:assert/strict";
import { test } from "node:test";

import { ChangeEdits, changeEdits, editsOf } from "../../../app/studio/page/changes/change_edits.js";
import { editsFile, projectWith } from "../../../app/studio/page/changes/edit_files.js";
import { withAdded, withBehavior, withoutBehavior, withWord } from "../../../app/studio/page/changes/edits.js";
import { successor } from "../../../app/studio/page/changes/following.js";
import { matching, sections } from "../../../app/studio/page/changes/gesture_browser.js";
import { Lexemes } from "../../../app/studio/page/changes/lexemes.js";
import { withMoved } from "../../../app/studio/page/changes/moving.js";
import { withHands } from "../../../app/studio/page/changes/pinning.js";
import { placeOf } from "../../../app/studio/page/changes/references.js";
import { EMPTY, PROJECT } from "../../../app/studio/page/state/project.js";
import { Store } from "../../../app/studio/page/state/store.js";
import { behavior, performance } from "../support/performances.js";

/** @import { Edits } from "understudy-client" */

/** @type {Edits} */
const NOTHING = { version: 1, words: [], behaviors: [] };
const GESTURE = behavior({ id: "gesture1", start_s: 0.1 });
const LINE = performance({ behaviors: [GESTURE] });
const UNEDITED = { performance: LINE, edits: NOTHING };

test("what is changed twice in a behaviour is one edit, and nothing where it is taken back", () => {
  const once = withBehavior(NOTHING, UNEDITED, GESTURE, { amount: 0.7 });
  const twice = withBehavior(once, UNEDITED, GESTURE, { hand: "left" });
  assert.equal(twice.behaviors?.length, 1);
  assert.deepEqual([twice.behaviors?.[0]?.amount, twice.behaviors?.[0]?.hand], [0.7, "left"]);
  const back = withBehavior(twice, UNEDITED, GESTURE, { amount: undefined, hand: undefined });
  assert.deepEqual(back.behaviors, []);
});

test("an edit is found again by its number in the performance that was made with it", () => {
  const edits = withAdded(NOTHING, { add: "head", on: { word: 1 }, lexeme: "NOD" });
  const nod = behavior({ id: "head1", kind: "head", lexeme: "NOD", first: 1, edit: 0 });
  const made = { performance: performance({ behaviors: [nod] }), edits };
  const larger = withBehavior(edits, made, nod, { amount: 0.9 });
  assert.deepEqual(larger.behaviors, [{ add: "head", on: { word: 1 }, lexeme: "NOD", amount: 0.9 }]);
  assert.deepEqual(withoutBehavior(larger, made, nod).behaviors, []);
});

test("a moment goes with the nearest edge of a word", () => {
  assert.deepEqual(placeOf(LINE, 0.1), { at: { word: 0, text: "No," }, edge: "start", offset_s: 0.1 });
  assert.deepEqual(placeOf(LINE, 0.9), { at: { word: 1, text: "never" }, edge: "end", offset_s: -0.1 });
});

test("a behaviour is moved by its stroke, and marks that were put somewhere go along", () => {
  const edits = withMoved(NOTHING, UNEDITED, GESTURE, "start", -0.05);
  const [edit] = edits.behaviors ?? [];
  assert.deepEqual(edit?.marks?.start, placeOf(LINE, 0.05));
  const moved = { ...GESTURE, edit: 0, sync: { ...GESTURE.sync, start: 0.05 } };
  const again = withMoved(edits, { performance: LINE, edits }, moved, null, 0.2);
  const marks = again.behaviors?.[0]?.marks;
  assert.deepEqual([marks?.start, marks?.stroke], [placeOf(LINE, 0.25), placeOf(LINE, 0.6)]);
});

test("a gesture that is moved stays what it is, by the hand that makes it", () => {
  const right = { ...GESTURE, hand: /** @type {const} */ ("right") };
  const [edit] = withMoved(NOTHING, UNEDITED, right, null, 0.1).behaviors ?? [];
  assert.deepEqual([edit?.lexeme, edit?.hand], ["NEGATION", "right"]);
});

test("a gesture that was chosen keeps the hand that it was first seen with", () => {
  const edits = withBehavior(NOTHING, UNEDITED, GESTURE, { lexeme: "STOP", lock: true });
  const stop = behavior({ id: "gesture1", lexeme: "STOP", hand: "right", edit: 0 });
  const kept = withHands({ performance: performance({ behaviors: [stop] }), edits });
  assert.equal(kept.behaviors?.[0]?.hand, "right");
  const later = performance({ behaviors: [{ ...stop, hand: "both" }] });
  assert.equal(withHands({ performance: later, edits: kept }), kept);
});

test("a word has one edit, which goes when it says nothing more", () => {
  const marked = withWord(NOTHING, LINE, 1, { mark: "still" });
  const timed = withWord(marked, LINE, 1, { start_s: 0.4, end_s: 0.9 });
  assert.deepEqual(timed.words, [{ at: { word: 1, text: "never" }, mark: "still", start_s: 0.4, end_s: 0.9 }]);
  assert.deepEqual(withWord(marked, LINE, 1, { mark: undefined }).words, []);
});

test("a change is undone, written and read", () => {
  const store = new Store();
  changeEdits(store, "Move gesture1", { ...NOTHING, words: [{ at: { word: 0 }, mark: "still" }] });
  const [written] = /** @type {any[]} */ (store.history.toJSON());
  store.history.undo();
  assert.equal(store.get(PROJECT).edits, null);
  ChangeEdits.fromJSON(store, written).execute();
  assert.equal(editsOf(store).words?.[0]?.mark, "still");
});

test("a file of edits says of the line what the options say, and sets them again", () => {
  const project = { ...EMPTY, options: { affect: "angry", seed: 4, lead_in_s: 0.5 }, edits: NOTHING };
  const file = editsFile(project);
  assert.deepEqual(file.line, { affect: "angry", seed: 4 });
  assert.deepEqual(projectWith(EMPTY, file), { options: { affect: "angry", seed: 4 }, edits: NOTHING });
});

test("the selection stays on its behaviour though ids are given anew", () => {
  const edits = withBehavior(NOTHING, UNEDITED, GESTURE, { amount: 0.7 });
  const other = behavior({ id: "gesture1", start_s: 0 });
  const same = behavior({ id: "gesture2", start_s: 0.5, edit: 0 });
  const now = { performance: performance({ behaviors: [other, same] }), edits };
  assert.equal(successor(UNEDITED, now, GESTURE)?.id, "gesture2");
});

test("gestures are found by family, those that show it first, and by name", () => {
  const families = { STOP: ["stop_refuse"], CUT: ["end_cut", "stop_refuse"], WAVE: ["greet"] };
  const lexemes = new Lexemes(/** @type {any} */ ({ lexemes: { gesture: ["CUT", "STOP", "WAVE"] }, families }));
  assert.deepEqual(matching(lexemes, "stop_refuse", ""), ["STOP", "CUT"]);
  assert.deepEqual(matching(lexemes, "", "wa"), ["WAVE"]);
  assert.deepEqual(sections(lexemes, "", "stop").map(({ found }) => found), [["STOP"], ["CUT"]]);
});
