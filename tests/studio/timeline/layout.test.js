import assert from "node:assert/strict";
import { test } from "node:test";

import { Axis } from "../../../app/studio/page/timeline/axis.js";
import { box, hitAt, LABELS_PX, placed } from "../../../app/studio/page/timeline/layout.js";
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

/** @param {ReturnType<typeof hitAt>} hit */
function named({ row, item, mark }) {
  return [row, item?.id, mark];
}
