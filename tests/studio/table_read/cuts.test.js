import assert from "node:assert/strict";
import { test } from "node:test";

import { cutAt, cutsOf } from "../../../app/studio/page/table_read/cuts.js";
import { lineAt, PAUSE_S, spansOf } from "../../../app/studio/page/table_read/sequence.js";

/** @import { SceneLine } from "../../../app/studio/page/table_read/scene_index.js" */

/**
 * @param {string} speaker
 * @param {string[]} listeners
 * @param {number} duration_s
 * @returns {SceneLine}
 */
function line(speaker, listeners, duration_s) {
  const heard = new Map(listeners.map((name) => [name, "m"]));
  return { id: "l", speaker, performer: "default", text: "", duration_s, sound: "s", motion: "m", listeners: heard };
}

const LINES = [line("A", ["B"], 8), line("B", ["A"], 3), line("A", ["B"], 0.8), line("C", [], 6)];
const SPANS = spansOf(LINES);

test("lines follow each other after a pause", () => {
  assert.deepEqual(SPANS.slice(0, 2), [{ start_s: 0, end_s: 8 }, { start_s: 8 + PAUSE_S, end_s: 11 + PAUSE_S }]);
  assert.deepEqual([0, 7.9, 8.2, 8.5, 999].map((time_s) => lineAt(SPANS, time_s)), [0, 0, 0, 1, 3]);
});

test("the scene is shown whole first and last", () => {
  const cuts = cutsOf(LINES, SPANS);
  assert.deepEqual([cuts[0]?.shot, cuts.at(-1)?.shot], ["wide", "wide"]);
});

test("whoever speaks is in the picture, but for a listener's reaction in a long line", () => {
  const cuts = cutsOf(LINES, SPANS);
  const subjects = [2.5, 5, 6.5, 9, 14].map((time_s) => cutAt(cuts, time_s)?.subject);
  assert.deepEqual(subjects, ["A", "B", "A", "B", "C"]);
});

test("no shot is shorter than can be seen", () => {
  const cuts = cutsOf(LINES, SPANS);
  cuts.slice(1).forEach(({ from_s }, place) => assert.ok(from_s - (cuts[place]?.from_s ?? 0) >= 1.2));
});

test("a scene without lines has no cuts", () => {
  assert.deepEqual(cutsOf([], []), []);
});
