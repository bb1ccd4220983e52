import assert from "node:assert/strict";
import { test } from "node:test";

import { colourOf, scenesOf } from "../../../app/studio/page/table_read/scenes.js";

const named = (/** @type {string[]} */ ids) => scenesOf(ids.map((id) => ({ id }))).map(({ name, places }) => [name, ...places]);

test("lines are in the scenes by which they are numbered", () => {
  assert.deepEqual(named(["scene1_001", "scene1_002", "scene2_001"]), [["Scene 1", 0, 1], ["Scene 2", 2]]);
  assert.deepEqual(named(["Act 1_a1", "Act 2_a1"]), [["Act 1 a", 0], ["Act 2 a", 1]]);
});

test("a script of one scene has no heading, in whatever order its lines are", () => {
  assert.deepEqual(named(["VO_001", "VO_007"]), [["", 0, 1]]);
  assert.deepEqual(named(["one", "two"]), [["", 0, 1]]);
});

test("everybody has a colour of his own until there are more people than colours", () => {
  const cast = ["a", "b", "c", "d", "e", "f", "g"];
  assert.deepEqual(["a", "f", "g"].map((name) => colourOf(cast, name)), [1, 6, 1]);
});
