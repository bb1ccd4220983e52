import assert from "node:assert/strict";
import { test } from "node:test";

import {
  isWithinReach,
  orientationOf,
  partnersOf,
  roomBehind,
  thumbsOf,
  timesAt,
  typesAt,
} from "../../../app/studio/page/gesture_editor/possible.js";
import { LANGUAGE } from "./small_language.js";

/** @import { GestureFrame } from "understudy-client" */

/** @param {readonly (readonly [time: number, type: string])[]} told */
function frames(told) {
  return /** @type {GestureFrame[]} */ (told.map(([time, type]) => ({ time, type, leading: {} })));
}

/** @param {readonly string[]} directions */
function partners(directions) {
  return [...partnersOf(LANGUAGE, directions)].map((index) => LANGUAGE.orientations[index]?.directions.join("") ?? "");
}

test("palm up leaves fingers away, inwards, outwards and towards, their sums, and in line with the forearm", () => {
  const left = partners(["Up"]);
  assert.deepEqual(left.filter((name) => ["Up", "Down"].some((word) => name.includes(word))), []);
  assert.deepEqual(new Set(left), new Set(["", "Away", "Towards", "Inwards", "Outwards", "InwardsAway", "InwardsTowards", "OutwardsAway", "OutwardsTowards"]));
});

test("fingers up and away leave palms at a right angle to both together", () => {
  const left = partners(["Up", "Away"]);
  assert.ok(left.includes("UpTowards") && left.includes("DownAway") && left.includes("Inwards"));
  assert.ok(!left.includes("Up") && !left.includes("Away"));
});

test("directions are the same in any order", () => {
  assert.equal(orientationOf(LANGUAGE, ["Away", "Up"]), orientationOf(LANGUAGE, ["Up", "Away"]));
  assert.equal(orientationOf(LANGUAGE, []), 0);
});

test("a pinch has no other thumb", () => {
  assert.deepEqual(thumbsOf(LANGUAGE, "symbol_pinch"), ["default"]);
  assert.equal(thumbsOf(LANGUAGE, "form_flat").length, 4);
});

test("types keep their order, and an instant comes once", () => {
  const told = frames([[0.1, "stroke_start"], [0.5, "stroke"], [0.9, "hold"]]);
  assert.deepEqual(typesAt(LANGUAGE, told, 1), ["stroke", "stroke_end", "hold"]);
  assert.deepEqual(typesAt(LANGUAGE, told, 0), ["start", "preparation", "ready", "stroke_start", "stroke"]);
  assert.deepEqual(typesAt(LANGUAGE, frames([[0, "stroke_start"], [0.4, "stroke_end"]]), 1), ["stroke", "stroke_end", "hold", "relax", "retraction", "end"]);
});

test("times rise between 0 and 1", () => {
  const told = frames([[0.1, "stroke_start"], [0.5, "stroke"], [0.9, "hold"]]);
  assert.deepEqual(timesAt(told, 0), [0, 0.49]);
  assert.deepEqual(timesAt(told, 1), [0.11, 0.89]);
  assert.deepEqual(timesAt(told, 2), [0.51, 1]);
});

test("a frame fits where there is time for it and a type", () => {
  assert.deepEqual(roomBehind(LANGUAGE, frames([[0.2, "stroke_start"], [0.6, "stroke_end"]]), 0), { time: 0.4, types: ["stroke"] });
  assert.equal(roomBehind(LANGUAGE, frames([[0.2, "start"], [0.21, "stroke_end"]]), 0), null);
  assert.equal(roomBehind(LANGUAGE, frames([[0.2, "stroke_end"], [1, "end"]]), 1), null);
});

test("a sector out of reach is known", () => {
  assert.equal(isWithinReach(LANGUAGE, { x: "XEP", y: "YUpperP", z: "ZFar" }), false);
  assert.equal(isWithinReach(LANGUAGE, { x: "XEP", y: "YUpperP", z: "ZNear" }), true);
});
