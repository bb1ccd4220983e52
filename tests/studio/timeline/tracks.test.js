import assert from "node:assert/strict";
import { test } from "node:test";

import { CHANNELS, listed, rowsOf } from "../../../app/studio/page/timeline/tracks.js";
import { behavior, foundFunction, performance } from "../support/performances.js";

const rowCalled = (/** @type {string} */ name, /** @type {ReturnType<typeof rowsOf>} */ rows) => rows.find((row) => row.name === name);

test("there is a row for each channel, also where nothing is on it", () => {
  const names = rowsOf(performance()).map(({ name }) => name);
  for (const name of ["words", "phones", "voice", "functions", "visemes", ...CHANNELS]) {
    assert.ok(names.includes(name), name);
  }
});

test("what overlaps lies in lanes, and what was dropped below what was kept", () => {
  const behaviors = [
    behavior({ id: "a" }),
    behavior({ id: "b", start_s: 0.3 }),
    behavior({ id: "c", start_s: 0.6 }),
    behavior({ id: "d", kept: false, lost_to: "a", reason: "too close" }),
  ];
  const row = rowCalled("gesture", rowsOf(performance({ behaviors })));
  assert.deepEqual(row?.items.map(({ id, lane }) => [id, lane]), [["a", 0], ["b", 1], ["c", 0], ["d", 2]]);
  assert.equal(row?.lanes, 3);
  assert.equal(row?.items.at(-1)?.why, "too close; gave way to a");
});

test("a gesture has seven marks and its phases, a head movement no phases", () => {
  const rows = rowsOf(performance({ behaviors: [behavior({ id: "a" }), behavior({ id: "h", kind: "head" })] }));
  const [gesture, head] = [rowCalled("gesture", rows)?.items[0], rowCalled("head", rows)?.items[0]];
  assert.equal(gesture?.marks.length, 7);
  assert.equal(gesture?.phases.length, 5);
  assert.equal(head?.phases.length, 0);
});

test("a word that is not spoken has no place in time", () => {
  const words = [{ index: 0, text: "—", phones: [] }];
  assert.deepEqual(rowCalled("words", rowsOf(performance({ words })))?.items, []);
});

test("the list has words, functions and behaviours in the order of time", () => {
  const line = performance({ behaviors: [behavior({ id: "a", start_s: 0.2 })], functions: [foundFunction({ id: "f1" })] });
  assert.deepEqual(listed(rowsOf(line)).map(({ item }) => item.id), ["word:0", "f1", "a", "word:1"]);
});
