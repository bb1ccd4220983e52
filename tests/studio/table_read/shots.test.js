import assert from "node:assert/strict";
import { test } from "node:test";

import { viewOf } from "../../../app/studio/page/table_read/shots.js";

const SCENE = { eyes_m: 1.6, reach_m: 0.65 };
const LEFT = { x: -0.65, z: 0 };
const RIGHT = { x: 0.65, z: 0 };

test("the camera stays on the side of the audience", () => {
  for (const shot of /** @type {const} */ (["wide", "close", "over_shoulder"])) {
    for (const [subject, beside] of [[LEFT, RIGHT], [RIGHT, LEFT]]) {
      const { from_m } = viewOf(shot, subject ?? LEFT, beside ?? RIGHT, SCENE);
      assert.ok(from_m[2] > 0.3, `${shot}: ${from_m.join(" ")}`);
    }
  }
});

test("over the shoulder is behind whoever listens and looks at whoever speaks", () => {
  const { from_m, at_m } = viewOf("over_shoulder", LEFT, RIGHT, SCENE);
  assert.ok(from_m[0] > RIGHT.x);
  assert.deepEqual([at_m[0], at_m[2]], [LEFT.x, LEFT.z]);
});

test("close keeps clear of the others", () => {
  const { from_m } = viewOf("close", LEFT, RIGHT, SCENE);
  assert.ok(Math.hypot(from_m[0] - RIGHT.x, from_m[2] - RIGHT.z) > 0.5);
});
