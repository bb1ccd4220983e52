import assert from "node:assert/strict";
import { test } from "node:test";

import { withArms, withPose } from "../../../app/studio/page/gesture_editor/arms.js";
import {
  canBeWithout,
  possibleHand,
  possibleWrist,
  withArm,
  withFrameBehind,
  withoutFrame,
  withTime,
  withType,
} from "../../../app/studio/page/gesture_editor/frames.js";
import { FIRST } from "../../../app/studio/page/gesture_editor/gestures.js";
import { LANGUAGE } from "./small_language.js";

test("a time stays between its neighbours", () => {
  assert.equal(withTime(FIRST, 0, 0.9).frames[0]?.time, 0.59);
  assert.equal(withTime(FIRST, 1, 7).frames[1]?.time, 1);
  assert.equal(withTime(FIRST, 1, 0.42).frames[1]?.time, 0.42);
  assert.equal(FIRST.frames[1]?.time, 0.6);
});

test("a frame is added between two, in the order of types", () => {
  const added = withFrameBehind(LANGUAGE, FIRST, 0);
  assert.deepEqual(added.frames.map(({ time, type }) => [time, type]), [[0.25, "stroke_start"], [0.425, "stroke"], [0.6, "stroke_end"]]);
  assert.deepEqual(withFrameBehind(LANGUAGE, FIRST, 1).frames.map(({ type }) => type), ["stroke_start", "stroke_end", "stroke"].with(2, "hold"));
});

test("the stroke and the first place cannot be removed", () => {
  assert.equal(canBeWithout(FIRST.frames, 0), false);
  assert.equal(canBeWithout(FIRST.frames, 1), false);
  const longer = withFrameBehind(LANGUAGE, FIRST, 0);
  assert.deepEqual(withoutFrame(longer, 1), FIRST);
});

test("a part that is left open is not there any more, and the other arm that says nothing is the mirror image", () => {
  const other = withArm(FIRST, 1, "other", { shoulder: 0.5 });
  assert.deepEqual(other.frames[1]?.other, { shoulder: 0.5 });
  assert.equal(withArm(other, 1, "other", { shoulder: undefined }).frames[1]?.other, null);
  assert.deepEqual(withArm(FIRST, 1, "leading", { place: undefined }).frames[1]?.leading, {});
});

test("a hand keeps its thumb where the form leaves it free", () => {
  assert.deepEqual(possibleHand(LANGUAGE, { form: "form_flat", thumb: "out" }), { form: "form_flat", thumb: "out" });
  assert.deepEqual(possibleHand(LANGUAGE, { form: "symbol_pinch", thumb: "out" }), { form: "symbol_pinch", thumb: "default" });
});

test("a direction that is not at a right angle to the other is not taken", () => {
  const up = possibleWrist(LANGUAGE, { finger_base: [], palm: [] }, { palm: ["Up"] });
  assert.deepEqual(up, { finger_base: [], palm: ["Up"] });
  assert.equal(possibleWrist(LANGUAGE, up, { finger_base: ["Down"] }), up);
  assert.deepEqual(possibleWrist(LANGUAGE, up, { finger_base: ["Away"] }).finger_base, ["Away"]);
});

test("a type that cannot be there is not taken", () => {
  assert.equal(withType(LANGUAGE, FIRST, 0, "hold"), FIRST);
  assert.equal(withType(LANGUAGE, FIRST, 1, "stroke").frames[1]?.type, "stroke");
});

test("a gesture of one arm says nothing of another", () => {
  const both = withArm(withArms(FIRST, "both"), 1, "other", { shoulder: 0.5 });
  assert.deepEqual(withArms(both, "both").frames[1]?.other, { shoulder: 0.5 });
  assert.equal(withArms(both, "right").frames[1]?.other, null);
  assert.equal(withArms(both, "").arms, null);
});

test("a pose goes to the arms that the gesture has", () => {
  /** @type {Record<"left" | "right", Record<string, [number, number, number]>>} */
  const arms = { left: { Hand: [1, 2, 3] }, right: { LowerArm: [0, -80, 0] } };
  assert.deepEqual(withPose(FIRST, 0, arms).frames[0]?.leading.joints, arms.right);
  assert.deepEqual(withPose(withArms(FIRST, "left"), 0, arms).frames[0]?.leading.joints, arms.left);
  const both = withPose(withArms(FIRST, "both"), 0, arms).frames[0];
  assert.deepEqual([both?.leading.joints, both?.other?.joints], [arms.right, arms.left]);
  assert.equal(withPose(withArms(FIRST, "both"), 0, { left: arms.right, right: arms.right }).frames[0]?.other, undefined);
});
