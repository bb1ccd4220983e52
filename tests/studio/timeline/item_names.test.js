import assert from "node:assert/strict";
import { test } from "node:test";

import { inLines, shortened } from "../../../app/studio/page/timeline/item_names.js";

/** As if each letter were ten pixels wide. */
const width = (/** @type {string} */ text) => 10 * text.length;

test("a name is whole where it fits, shortened where not, and left out where it could not be read", () => {
  assert.deepEqual([60, 40, 20, 5].map((room) => shortened("glance", room, width)), ["glance", "gla…", "g…", ""]);
});

test("short words have their names on two lines, none over another", () => {
  const shown = inLines([{ left: 0, text: "those" }, { left: 20, text: "lights" }, { left: 60, text: "before" }], width);
  assert.deepEqual(shown, [
    { left: 0, line: 0, text: "those" },
    { left: 20, line: 1, text: "lights" },
    { left: 60, line: 0, text: "before" },
  ]);
});

test("a name ends where the one after the next begins, so that this one has a line", () => {
  const shown = inLines([{ left: 0, text: "interesting" }, { left: 20, text: "it" }, { left: 53, text: "is" }], width);
  assert.deepEqual(shown.map(({ line, text }) => [line, text]), [[0, "inte…"], [1, "it"], [0, "is"]]);
});
