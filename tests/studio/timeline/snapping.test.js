import assert from "node:assert/strict";
import { test } from "node:test";

import { Axis } from "../../../app/studio/page/timeline/axis.js";
import { snapped, targetsOf } from "../../../app/studio/page/timeline/snapping.js";
import { behavior, performance } from "../support/performances.js";

const AXIS = new Axis({ start_s: 0, length_s: 1 }, 0, 100);

test("what is dragged snaps to the nearest time within five pixels", () => {
  assert.deepEqual([0.52, 0.46, 0.56].map((time_s) => snapped(time_s, [0.5, 0.47], AXIS)), [0.5, 0.47, null]);
  assert.equal(snapped(0.5, [], AXIS), null);
});

test("it snaps to edges of words, other strokes and the playhead, not to itself", () => {
  const behaviors = [behavior({ id: "a" }), behavior({ id: "b", start_s: 2 })];
  assert.deepEqual(targetsOf(performance({ behaviors }), "a", 0.75), [0, 0.5, 0.5, 1, 2.3, 0.75]);
});
