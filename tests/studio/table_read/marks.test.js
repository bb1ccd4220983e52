import assert from "node:assert/strict";
import { test } from "node:test";

import { facing, marksOf, turned } from "../../../app/studio/page/table_read/marks.js";

/** @param {number} count */
const names = (count) => Array.from({ length: count }, (_, place) => `n${place}`);
const near = (/** @type {number | undefined} */ one, /** @type {number} */ other) => assert.ok(Math.abs((one ?? NaN) - other) < 1e-9, `${one} is not ${other}`);

test("two stand opposite each other, the first on the left of the audience", () => {
  const marks = marksOf(names(2));
  near(marks.get("n0")?.x, -0.65);
  near(marks.get("n1")?.x, 0.65);
  near(marks.get("n0")?.z, 0);
});

test("nobody is nearer to another than an arm's length, and nobody stands before the audience's middle", () => {
  for (const count of [2, 3, 5, 8]) {
    const places = [...marksOf(names(count)).values()];
    for (const [index, { x, z }] of places.entries()) {
      assert.ok(Math.abs(x) > 0.2 || z <= 0, `${count}: ${x} ${z}`);
      places.slice(0, index).forEach((other) => assert.ok(Math.hypot(x - other.x, z - other.z) > 0.899));
    }
  }
});

test("the speaker looks at whom he speaks to, his body between that and the middle; everybody else faces the speaker", () => {
  const marks = new Map([["a", { x: -1, z: 0 }], ["b", { x: 1, z: 1 }], ["c", { x: 1, z: -1 }]]);
  const turn = { speaker: "a", listeners: ["b", "c"] };
  const toB = Math.atan2(2, 1);
  near(facing("a", turn, marks).gaze_rad, toB);
  near(facing("a", turn, marks).body_rad, (toB + Math.PI / 2) / 2);
  for (const listeners of [["b"], ["c", "b"], []]) {
    const { body_rad, gaze_rad } = facing("b", { speaker: "a", listeners }, marks);
    near(body_rad, Math.atan2(-2, -1));
    near(gaze_rad, body_rad);
  }
  near(facing("a", { speaker: "a", listeners: [] }, marks).gaze_rad, Math.PI / 2);
});

test("whoever is alone faces the audience", () => {
  near(facing("a", { speaker: "a", listeners: [] }, marksOf(["a"])).body_rad, 0);
});

test("people turn the shorter way round", () => {
  near(turned(3, -3, 1) - 2 * Math.PI, -3);
  near(turned(0, 1, 0), 0);
  near(turned(0, 1, 0.5), 0.5);
});
