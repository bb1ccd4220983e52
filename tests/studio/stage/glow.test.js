import assert from "node:assert/strict";
import { test } from "node:test";

import { takesPart } from "../../../app/studio/page/stage/glow.js";

test("a gesture is made by its arm or both, everything else by its part of the body", () => {
  const joints = ["leftHand", "rightUpperArm", "rightIndexDistal", "head", "chest"];
  const parts = (/** @type {Parameters<typeof takesPart>[1]} */ behavior) => joints.filter((joint) => takesPart(joint, behavior));
  assert.deepEqual(parts({ kind: "gesture", hand: "right" }), ["rightUpperArm", "rightIndexDistal"]);
  assert.deepEqual(parts({ kind: "gesture", hand: "both" }), ["leftHand", "rightUpperArm", "rightIndexDistal"]);
  assert.deepEqual(parts({ kind: "face" }), ["head"]);
  assert.deepEqual(parts({ kind: "posture" }), ["chest"]);
  assert.deepEqual(parts({ kind: "unknown" }), []);
});
