import assert from "node:assert/strict";
import { test } from "node:test";

import { GROUPS, groupOf, searchedText } from "../../../app/studio/page/naming/groups.js";
import { functionName } from "../../../app/studio/page/naming/meanings.js";
import { movementName, plainText } from "../../../app/studio/page/naming/movements.js";

test("movements have names that people use, an author's own ones their lexeme in plain letters", () => {
  assert.equal(movementName("gesture", "POINT_FRONT"), "Point ahead");
  assert.equal(movementName("head", "TILT_LEFT"), "Tilt the head left");
  assert.equal(movementName("gesture", "SHOW_WHATEVER"), "Show whatever");
});

test("the service's reasons are told without its names and numbers", () => {
  assert.equal(plainText("QUESTION is worth more there than this (-3.0 in log-odds)"), "“Question” is worth more there than this");
  assert.equal(plainText("none_empty is worth more"), "none empty is worth more");
});

test("a function is called by its subtype where that says more", () => {
  assert.equal(functionName({ class: "deixis", subtype: "self" }), "the speaker");
  assert.equal(functionName({ class: "negation", subtype: "" }), "a no");
  assert.equal(functionName({ class: "own_class" }), "own class");
});

test("gestures are in the group of what they most likely mean, and found by it", () => {
  assert.equal(groupOf(["shrug", "weigh"]).name, "Yes, no and perhaps");
  assert.equal(groupOf(["of_my_own"]), GROUPS.at(-1));
  assert.ok(searchedText("SHRUG", ["shrug"]).includes("know"));
});
