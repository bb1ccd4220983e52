import assert from "node:assert/strict";
import { test } from "node:test";

import { SHOTS, viewOf } from "../../../app/studio/page/stage/cameras.js";

const EYES_M = 1.6;

/** How far a point is from the line of sight, seen from above; metres. */
function besideSight(/** @type {ReturnType<typeof viewOf>} */ { from_m, at_m }, /** @type {readonly number[]} */ [x = 0, , z = 0]) {
  const [dx, dz] = [at_m[0] - from_m[0], at_m[2] - from_m[2]];
  return Math.abs(dx * (z - from_m[2]) - dz * (x - from_m[0])) / Math.hypot(dx, dz);
}

test("every shot looks at the speaker from before him", () => {
  for (const [shot] of SHOTS) {
    const { from_m, at_m } = viewOf(shot, EYES_M, null);
    assert.ok(from_m[2] > 0.5 && Math.hypot(at_m[0], at_m[2]) < 0.1, shot);
  }
});

test("nobody is hidden by who listens", () => {
  const listener = /** @type {const} */ ([0, 1.6, 1.7]);
  for (const shot of /** @type {const} */ (["wide", "medium", "over_shoulder"])) {
    assert.ok(besideSight(viewOf(shot, EYES_M, [...listener]), listener) > 0.2, shot);
  }
});
