/** Draws the items of a row: bars with phases and marks below their names, and which of them are selected. */

import { drawSpilling } from "./item_names.js";
import { box } from "./layout.js";
import { PHASE_COLOURS } from "./phases.js";

/** @import { Pen, Picture } from "./drawing.js" */
/** @import { PlacedRow } from "./layout.js" */
/** @import { Item, Row } from "./tracks.js" */

/** @typedef {ReturnType<typeof box>} Place */

const FAINT = 0.45;
const STRIP_PX = 9;
const TICK_PX = 4;

/**
 * Whether the items of a row are what is said, one right after the other.
 *
 * @param {Row} row
 */
export function isSpoken({ kind, name }) {
  return kind === "wave" || name === "phones";
}

/**
 * @param {Pen} pen
 * @param {Picture} picture
 * @param {PlacedRow} placedRow
 * @param {Item} item
 */
export function drawItem(pen, picture, placedRow, item) {
  const { axis } = picture;
  const place = box(placedRow, item, axis);
  if (place.left > axis.left_px + axis.width_px || place.left + place.width < axis.left_px) {
    return;
  }
  pen.globalAlpha = item.kept ? 1 : FAINT;
  drawBar(pen, picture, placedRow, item);
  if (!placedRow.folded) {
    drawPhases(pen, picture, item, place);
    drawMarks(pen, picture, item, place);
  }
  if (!placedRow.folded && !isSpoken(placedRow.row)) {
    drawSpilling(pen, picture, item, place);
  }
  pen.globalAlpha = 1;
  outline(pen, picture, item, place);
}

/**
 * @param {Pen} pen
 * @param {Picture} picture
 * @param {PlacedRow} placedRow
 * @param {Item} item
 */
function drawBar(pen, { axis, palette, differing }, placedRow, item) {
  const { left, top, width, height } = box(placedRow, item, axis);
  const filled = height * (item.share ?? 1);
  pen.fillStyle = palette.rows[placedRow.row.name] ?? palette.faint;
  pen.beginPath();
  pen.roundRect(left, top + height - filled, width, filled, 3);
  pen.fill();
  if (differing.has(item.id)) {
    pen.fillStyle = palette.differs;
    pen.fillRect(left, top, 4, height);
  }
}

/**
 * @param {Pen} pen
 * @param {Picture} picture
 * @param {Item} item
 * @param {Place} place
 */
function drawPhases(pen, { axis }, { phases }, { top, height }) {
  for (const { name, start_s, end_s } of phases) {
    pen.fillStyle = PHASE_COLOURS[name];
    pen.fillRect(axis.px(start_s), top + height - STRIP_PX, axis.px(end_s) - axis.px(start_s), STRIP_PX);
  }
}

/**
 * Marks are below the name, so that it can be read.
 *
 * @param {Pen} pen
 * @param {Picture} picture
 * @param {Item} item
 * @param {Place} place
 */
function drawMarks(pen, { axis, palette }, { marks, phases }, { top, height }) {
  const tick_px = phases.length > 0 ? STRIP_PX : TICK_PX;
  pen.fillStyle = palette.ink;
  for (const [mark, time_s] of marks) {
    const wide_px = mark === "stroke" ? 2 : 1;
    pen.fillRect(axis.px(time_s) - wide_px / 2, top + height - tick_px, wide_px, tick_px);
  }
}

/**
 * @param {Pen} pen
 * @param {Picture} picture
 * @param {Item} item
 * @param {Place} place
 */
function outline(pen, { palette, selected, marked }, { id }, { left, top, width, height }) {
  if (selected === id || marked.includes(id)) {
    pen.strokeStyle = palette.focus;
    pen.lineWidth = 2;
    pen.strokeRect(left, top, width, height);
    pen.lineWidth = 1;
  }
}
