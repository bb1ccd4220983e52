import assert from "node:assert/strict";
import { test } from "node:test";

import { wristPath } from "../../../app/studio/page/stage/wrist_path.js";

/** @import { Clip } from "understudy-client" */

const HALF = Math.SQRT1_2;

/** @param {number[]} values @param {number} size */
function track(values, size) {
  const timesS = Float32Array.from({ length: values.length / size }, (_, index) => index);
  return { timesS, values: Float32Array.from(values), size };
}

/** A hand a metre out from a shoulder that is a metre up, and turns by a right angle within a second. @type {Clip} */
const CLIP = {
  durationS: 1,
  audioOffsetS: 0,
  joints: [
    { name: "hips", parent: null, offsetM: [0, 1, 0] },
    { name: "leftUpperArm", parent: "hips", offsetM: [0, 1, 0] },
    { name: "leftHand", parent: "leftUpperArm", offsetM: [1, 0, 0] },
  ],
  hips: track([0, 1, 0], 3),
  turns: new Map([["leftUpperArm", track([0, 0, 0, 1, 0, 0, HALF, HALF], 4)]]),
  shapes: new Map(),
  visemes: new Map(),
  events: [],
};

test("a wrist is where the joints that carry it take it", () => {
  const path = wristPath(CLIP, "left", 2);
  const expected = [[1, 2, 0], [HALF, 2 + HALF, 0], [0, 3, 0]];
  assert.equal(path.length, expected.length);
  for (const [index, place] of path.entries()) {
    place.forEach((metres, axis) => assert.ok(Math.abs(metres - (expected[index]?.[axis] ?? NaN)) < 1e-6));
  }
});
