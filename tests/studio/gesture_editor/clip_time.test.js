import assert from "node:assert/strict";
import { test } from "node:test";

import { clipTime } from "../../../app/studio/page/gesture_editor/clip_time.js";
import { FIRST } from "../../../app/studio/page/gesture_editor/gestures.js";

const EVENTS = [["start", 0.8], ["stroke_start", 1.1], ["stroke_end", 1.6]].map(([point, timeS]) => ({ behavior: "gesture", point: String(point), timeS: Number(timeS) }));

test("frames are where the clip has them: the stroke's ends, and in proportion before and behind", () => {
  assert.ok(Math.abs(clipTime(FIRST, EVENTS, 0.25) - 1.1) < 1e-9);
  assert.ok(Math.abs(clipTime(FIRST, EVENTS, 0.6) - 1.6) < 1e-9);
  assert.ok(Math.abs(clipTime(FIRST, EVENTS, 0.95) - 2.1) < 1e-9);
});

test("a stroke that no frame begins comes from the frame before", () => {
  const frames = FIRST.frames.map((frame, index) => ({ ...frame, type: /** @type {const} */ (["hold", "stroke"])[index] ?? frame.type }));
  assert.ok(Math.abs(clipTime({ ...FIRST, frames }, EVENTS, 0.25) - 1.1) < 1e-9);
});

test("without a stroke in the clip it is at the beginning", () => {
  assert.equal(clipTime(FIRST, [], 0.6), 0);
});
