import assert from "node:assert/strict";
import { test } from "node:test";

import { columns, rows } from "../../../app/studio/page/gesture_editor/sector_places.js";
import { LANGUAGE } from "./small_language.js";

test("seen from before, the right hand's own side is on the left, and the left hand's on the right", () => {
  assert.deepEqual(columns(LANGUAGE, "right").map(({ name }) => name), ["XEP", "XC", "XOppC"]);
  assert.deepEqual(columns(LANGUAGE, "left").map(({ name }) => name), ["XOppC", "XC", "XEP"]);
});

test("the highest sector is at the top, and stretches fill the picture without gaps", () => {
  const found = rows(LANGUAGE);
  assert.deepEqual(found.map(({ name }) => name), ["YUpperP", "YCC", "YLowerP"]);
  assert.equal(found[0]?.from, 0);
  assert.equal(found.at(-1)?.to, 1);
  assert.deepEqual(found.slice(1).map(({ from }) => from), found.slice(0, -1).map(({ to }) => to));
});

test("borders are midway between the sectors", () => {
  const [outer, middle] = columns(LANGUAGE, "right");
  // .54 and .20 m from the middle: the border is at .37, and the outer column reaches as far beyond .54
  const [begin, end] = [0.71, -0.06 - 0.13];
  assert.ok(Math.abs((outer?.to ?? 0) - (begin - 0.37) / (begin - end)) < 1e-9);
  assert.equal(middle?.from, outer?.to);
});
