import assert from "node:assert/strict";
import { test } from "node:test";

import { Axis } from "../../../app/studio/page/timeline/axis.js";
import { box, FINGER_LANE_PX, FINGER_NEAR_PX, hitAt, LABELS_PX, placed, RULER_PX } from "../../../app/studio/page/timeline/layout.js";
import { rowsOf } from "../../../app/studio/page/timeline/tracks.js";
import { behavior, performance } from "../support/performances.js";

const ROWS = placed(rowsOf(performance({ behaviors: [behavior({ id: "a", start_s: 0.2 })] })));
const AXIS = new Axis({ start_s: 0, length_s: 1 }, LABELS_PX, 1000);

/** The middle of the gesture's box. */
function middle() {
  const row = ROWS.find((each) => each.row.name === "gesture");
  const item = row?.row.items[0];
  assert.ok(row && item);
  const { top, height } = box(row, item, AXIS);
  return top + height / 2;
}

test("rows lie below each other", () => {
  for (const [index, row] of ROWS.slice(1).entries()) {
    const above = ROWS[index];
    assert.ok(above && row.top_px >= above.top_px + above.height_px);
  }
});

test("under the pointer is an item, near a mark that mark, and beside it nothing", () => {
  const y = middle();
  assert.deepEqual(named(hitAt(ROWS, AXIS, AXIS.px(0.45), y)), ["gesture", "a", null]);
  assert.deepEqual(named(hitAt(ROWS, AXIS, AXIS.px(0.5) + 2, y)), ["gesture", "a", "stroke"]);
  assert.deepEqual(named(hitAt(ROWS, AXIS, AXIS.px(0.1), y)), ["gesture", undefined, null]);
  assert.deepEqual(named(hitAt(ROWS, AXIS, AXIS.px(0.1), 2)), ["ruler", undefined, null]);
});

test("for a finger marks, lanes and the ruler are at least 24 pixels", () => {
  const y = middle();
  const beside = AXIS.px(0.5) + 11;
  assert.deepEqual(named(hitAt(ROWS, AXIS, beside, y)), ["gesture", "a", null]);
  assert.deepEqual(named(hitAt(ROWS, AXIS, beside, y, FINGER_NEAR_PX)), ["gesture", "a", "stroke"]);
  const rows = placed(rowsOf(performance({ behaviors: [behavior({ id: "a", start_s: 0.2 })] })), undefined, FINGER_LANE_PX);
  for (const { row, height_px } of rows.filter(({ row: { items } }) => items.length > 0)) {
    assert.ok(height_px >= 24, row.name);
  }
  assert.ok(2 * FINGER_NEAR_PX >= 24 && RULER_PX >= 24);
});

/** @param {ReturnType<typeof hitAt>} hit */
function named({ row, item, mark }) {
  return [row, item?.id, mark];
}
