import assert from "node:assert/strict";
import { test } from "node:test";

import { timeOf } from "../../../app/studio/page/state/selecting.js";
import { behavior, foundFunction, performance } from "../support/performances.js";

const LINE = performance({
  behaviors: [behavior({ id: "gesture1", start_s: 2 }), { ...behavior({ id: "gaze1" }), sync: { start: 1, end: 2 } }],
  functions: [foundFunction({ id: "f1", start_s: 0.25 })],
});

test("a movement is looked at where its stroke is, else in its middle; everything else where it begins", () => {
  assert.equal(timeOf(LINE, "gesture1")?.toFixed(3), "2.300");
  assert.equal(timeOf(LINE, "gaze1"), 1.5);
  assert.equal(timeOf(LINE, "f1"), 0.25);
  assert.equal(timeOf(LINE, "word:1"), 0.5);
  assert.equal(timeOf(LINE, "nothing"), null);
});
