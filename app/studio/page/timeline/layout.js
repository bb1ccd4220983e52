/** Where rows and items are on the timeline's canvas, and what is under a point of it. Pixels, from the top left. */

/** @import { Axis } from "./axis.js" */
/** @import { Looks } from "./looks.js" */
/** @import { Item, Row } from "./tracks.js" */

/** `lane_px` is the height of a lane; a folded row is one line of bars. @typedef {Readonly<{ row: Row, top_px: number, height_px: number, lane_px: number, folded: boolean }>} PlacedRow */

/**
 * What is under a point: an item and perhaps one of its marks, or nothing but a row (`ruler` for the top).
 *
 * @typedef {Readonly<{ row: string, item: Item | null, mark: string | null }>} Hit
 */

export const LABELS_PX = 104;
export const RULER_PX = 24;
/** The two lines of words below the wave. */
export const WORDS_PX = 28;
const FOLDED_PX = 16;
const GAP_PX = 3;
/** How near to a mark or an edge a pointer presses it. */
const NEAR_PX = 4;
/** The same of a finger, for which 24 pixels are the least that can be hit (WCAG 2.2, 2.5.8), lanes included. */
export const FINGER_NEAR_PX = 12;
export const FINGER_LANE_PX = 26;
const HEIGHTS_PX = Object.freeze({ wave: 62, voice: 40 });
/** @type {Readonly<Record<string, number>>} */
const LANES_PX = Object.freeze({ gesture: 28, compared: 28, phones: 24 });
const LANE_PX = 19;

/**
 * @param {readonly Row[]} rows
 * @param {Readonly<Pick<Looks, "folded" | "heights">>} [looks]
 * @param {number} [least_px] how high lanes are at least
 * @returns {PlacedRow[]}
 */
export function placed(rows, { folded, heights } = { folded: {}, heights: {} }, least_px = 0) {
  let top_px = RULER_PX;
  return rows.map((row) => {
    const share = heights[row.name] ?? 1;
    const lane_px = Math.max(least_px, Math.round((LANES_PX[row.name] ?? LANE_PX) * share));
    const open_px = row.kind === "items" ? row.lanes * lane_px : Math.round(HEIGHTS_PX[row.kind] * share);
    const isFolded = folded[row.name] ?? false;
    const height_px = isFolded ? FOLDED_PX : open_px;
    const found = { row, top_px, height_px, lane_px, folded: isFolded };
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
export function box({ row, top_px, height_px, lane_px, folded }, item, axis) {
  const left = axis.px(item.start_s);
  const width = Math.max(2, axis.px(item.end_s) - left);
  if (folded) {
    return { left, top: top_px + 4, width, height: FOLDED_PX - 8 };
  }
  const isWave = row.kind === "wave";
  const top = isWave ? top_px + height_px - WORDS_PX : top_px + item.lane * lane_px;
  return { left, top, width, height: (isWave ? WORDS_PX : lane_px) - 2 };
}

/**
 * @param {readonly PlacedRow[]} rows
 * @param {Axis} axis
 * @param {number} x
 * @param {number} y
 * @param {number} [near_px] how near to an edge or a mark is on it
 * @returns {Hit}
 */
export function hitAt(rows, axis, x, y, near_px = NEAR_PX) {
  const placedRow = rows.find(({ top_px, height_px }) => y >= top_px && y < top_px + height_px + GAP_PX);
  if (!placedRow) {
    return { row: y < RULER_PX ? "ruler" : "", item: null, mark: null };
  }
  const under = placedRow.row.items.filter((item) => {
    const { left, top, width, height } = box(placedRow, item, axis);
    return x >= left - near_px && x <= left + width + near_px && y >= top && y <= top + height;
  });
  const item = under.find(({ start_s, end_s }) => x >= axis.px(start_s) && x <= axis.px(end_s)) ?? under[0] ?? null;
  return { row: placedRow.row.name, item, mark: item && markAt(item, axis, x, near_px) };
}

/**
 * The mark of an item that is nearest to a point, if one is near.
 *
 * @param {Item} item
 * @param {Axis} axis
 * @param {number} x
 * @param {number} near_px
 */
function markAt(item, axis, x, near_px) {
  const near = item.marks
    .map(([mark, time_s]) => ({ mark, far_px: Math.abs(axis.px(time_s) - x) }))
    .filter(({ far_px }) => far_px <= near_px)
    .sort((a, b) => a.far_px - b.far_px);
  return near[0]?.mark ?? null;
}
