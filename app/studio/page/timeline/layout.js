/** Where rows and items are on the timeline's canvas, and what is under a point of it. Pixels, from the top left. */

/** @import { Axis } from "./axis.js" */
/** @import { Item, Row } from "./tracks.js" */

/** @typedef {Readonly<{ row: Row, top_px: number, height_px: number }>} PlacedRow */

/**
 * What is under a point: an item and perhaps one of its marks, or nothing but a row (`ruler` for the top).
 *
 * @typedef {Readonly<{ row: string, item: Item | null, mark: string | null }>} Hit
 */

export const LABELS_PX = 78;
export const RULER_PX = 18;
export const LANE_PX = 16;
const GAP_PX = 4;
const NEAR_PX = 4;
const HEIGHTS_PX = Object.freeze({ wave: 48, voice: 36 });

/**
 * @param {readonly Row[]} rows
 * @returns {PlacedRow[]}
 */
export function placed(rows) {
  let top_px = RULER_PX;
  return rows.map((row) => {
    const height_px = row.kind === "items" ? row.lanes * LANE_PX : HEIGHTS_PX[row.kind];
    const found = { row, top_px, height_px };
    top_px += height_px + GAP_PX;
    return found;
  });
}

/** @param {readonly PlacedRow[]} rows */
export function heightOf(rows) {
  const last = rows.at(-1);
  return last ? last.top_px + last.height_px + GAP_PX : RULER_PX;
}

/**
 * Where an item's rectangle is.
 *
 * @param {PlacedRow} placedRow
 * @param {Item} item
 * @param {Axis} axis
 */
export function box({ row, top_px, height_px }, item, axis) {
  const left = axis.px(item.start_s);
  const isWave = row.kind === "wave";
  const top = isWave ? top_px + height_px - LANE_PX : top_px + item.lane * LANE_PX;
  return { left, top, width: Math.max(2, axis.px(item.end_s) - left), height: LANE_PX - 3 };
}

/**
 * @param {readonly PlacedRow[]} rows
 * @param {Axis} axis
 * @param {number} x
 * @param {number} y
 * @returns {Hit}
 */
export function hitAt(rows, axis, x, y) {
  const placedRow = rows.find(({ top_px, height_px }) => y >= top_px && y < top_px + height_px + GAP_PX);
  if (!placedRow) {
    return { row: y < RULER_PX ? "ruler" : "", item: null, mark: null };
  }
  const under = placedRow.row.items.filter((item) => {
    const { left, top, width, height } = box(placedRow, item, axis);
    return x >= left - NEAR_PX && x <= left + width + NEAR_PX && y >= top && y <= top + height;
  });
  const item = under.find(({ start_s, end_s }) => x >= axis.px(start_s) && x <= axis.px(end_s)) ?? under[0] ?? null;
  return { row: placedRow.row.name, item, mark: item && markAt(item, axis, x) };
}

/**
 * The mark of an item that is nearest to a point, if one is near.
 *
 * @param {Item} item
 * @param {Axis} axis
 * @param {number} x
 */
function markAt(item, axis, x) {
  const near = item.marks
    .map(([mark, time_s]) => ({ mark, far_px: Math.abs(axis.px(time_s) - x) }))
    .filter(({ far_px }) => far_px <= NEAR_PX)
    .sort((a, b) => a.far_px - b.far_px);
  return near[0]?.mark ?? null;
}
