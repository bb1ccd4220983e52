import assert from "node:assert/strict";
import { test } from "node:test";

import { SHOTS, viewOf } from "../../../app/studio/page/stage/cameras.js";
import { distanceFor, FIELD_DEG, isClear, roundFrom } from "../../../app/studio/page/stage/framing.js";

const EYES_M = 1.6;
const SPEAKER = Object.freeze({ x: 0, z: 0, facing_rad: 0 });
const PLACES = /** @type {const} */ ([[0, 1.6, 1.7], [0.6, 1.5, 1.4], [-1.2, 1.7, 0.9]]);

test("every shot looks at the speaker from before him", () => {
  for (const [shot] of SHOTS) {
    const view = viewOf(shot, EYES_M, null);
    assert.ok(view.from_m[2] > 0.5 && Math.hypot(view.at_m[0], view.at_m[2]) < 0.1, shot);
    assert.ok(roundFrom(view, SPEAKER) < 0.5, shot);
  }
});

test("wherever somebody listens, he hides neither face nor hands, and the camera is in nobody", () => {
  for (const [x, y, z] of PLACES) {
    for (const [shot] of SHOTS.filter(([name]) => name !== "over_shoulder")) {
      const view = viewOf(shot, EYES_M, [x, y, z]);
      assert.ok(isClear(view, SPEAKER, [{ x, z }]), `${shot} past ${String(x)} ${String(z)}`);
      assert.ok(roundFrom(view, SPEAKER) < 1.3, shot);
    }
  }
});

test("over the shoulder the camera is behind whoever listens, and beside his line of sight", () => {
  const { from_m, at_m } = viewOf("over_shoulder", EYES_M, [0, 1.6, 1.7]);
  assert.ok(from_m[2] > 2.2 && Math.abs(from_m[0]) > 0.5);
  assert.deepEqual([at_m[0], at_m[2]], [0, 0]);
});

test("a narrow picture is taken from further away, so that hands stay in it", () => {
  const half = Math.tan((FIELD_DEG * Math.PI) / 360);
  const away_m = distanceFor(1.6, 1, 0.5);
  assert.ok(2 * half * away_m * 0.5 >= 1.6);
  assert.ok(distanceFor(1.6, 1, 2) < away_m);
  const far = (/** @type {ReturnType<typeof viewOf>} */ { from_m, at_m }) => Math.hypot(from_m[0] - at_m[0], from_m[2] - at_m[2]);
  assert.ok(far(viewOf("medium", EYES_M, null, { aspect: 0.6 })) > far(viewOf("medium", EYES_M, null)) + 1);
});
