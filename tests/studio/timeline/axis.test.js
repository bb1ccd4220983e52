import assert from "node:assert/strict";
import { test } from "node:test";

import { Axis, scrolled, within, zoomed } from "../../../app/studio/page/timeline/axis.js";

test("seconds and pixels are each other's inverse", () => {
  const axis = new Axis({ start_s: 2, length_s: 4 }, 80, 400);
  assert.equal(axis.px(2), 80);
  assert.equal(axis.px(6), 480);
  assert.equal(axis.time_s(axis.px(3.3)), 3.3);
});

test("zooming keeps the pointer's time in its place", () => {
  const before = new Axis({ start_s: 0, length_s: 8 }, 0, 800);
  const after = new Axis(zoomed(before.stretch, 0.5, 6, 8), 0, 800);
  assert.equal(after.stretch.length_s, 4);
  assert.equal(after.px(6), before.px(6));
});

test("nothing outside of the line is shown, nor less than can be looked at", () => {
  assert.deepEqual(scrolled({ start_s: 6, length_s: 2 }, 5, 8), { start_s: 6, length_s: 2 });
  assert.deepEqual(scrolled({ start_s: 1, length_s: 2 }, -5, 8), { start_s: 0, length_s: 2 });
  assert.deepEqual(within({ start_s: 0, length_s: Infinity }, 8), { start_s: 0, length_s: 8 });
  assert.equal(zoomed({ start_s: 0, length_s: 1 }, 0.001, 0.5, 8).length_s, 0.25);
});
