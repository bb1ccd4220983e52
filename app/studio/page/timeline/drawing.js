/** Draws the timeline: rows, items with their phases and marks, what is selected. Colours are the page's. */

import { box, LABELS_PX, LANE_PX, RULER_PX } from "./layout.js";
import { PHASE_COLOURS } from "./phases.js";
import { drawVoice, drawWave } from "./signals.js";

/** @import { Axis } from "./axis.js" */
/** @import { Palette } from "./palette.js" */
/** @import { PlacedRow } from "./layout.js" */
/** @import { Signals } from "./signals.js" */
/** @import { Item } from "./tracks.js" */

/**
 * Everything that a picture of the timeline depends on. `badges` are short texts behind items' names, by id.
 *
 * @typedef {object} Picture
 * @property {readonly PlacedRow[]} rows
 * @property {Axis} axis
 * @property {Palette} palette
 * @property {Signals} signals
 * @property {string | null} selected
 * @property {readonly [number, number] | null} loop
 * @property {Readonly<Record<string, string>>} badges
 * @property {number} height_px
 */

/** @typedef {CanvasRenderingContext2D} Pen */

const TICKS_S = [0.05, 0.1, 0.25, 0.5, 1, 2, 5, 10, 30, 60];
const NARROWEST_TICK_PX = 55;
const LABEL_PX = 20;
const FAINT = 0.45;

/**
 * @param {Pen} pen
 * @param {Picture} picture
 */
export function draw(pen, picture) {
  const { axis, palette, height_px } = picture;
  pen.fillStyle = palette.panel;
  pen.fillRect(0, 0, axis.left_px + axis.width_px, height_px);
  pen.font = "11px system-ui, sans-serif";
  pen.textBaseline = "middle";
  drawLoop(pen, picture);
  drawRuler(pen, picture);
  for (const placedRow of picture.rows) {
    drawRow(pen, picture, placedRow);
  }
  drawLabels(pen, picture);
}

/**
 * @param {Pen} pen
 * @param {Picture} picture
 */
function drawLoop(pen, { axis, palette, loop, height_px }) {
  if (loop) {
    pen.fillStyle = palette.faint;
    pen.fillRect(axis.px(loop[0]), 0, axis.px(loop[1]) - axis.px(loop[0]), height_px);
  }
}

/**
 * @param {Pen} pen
 * @param {Picture} picture
 */
function drawRuler(pen, { axis, palette, height_px }) {
  const { start_s, length_s } = axis.stretch;
  const step_s = TICKS_S.find((each) => (each / length_s) * axis.width_px >= NARROWEST_TICK_PX) ?? 60;
  for (let time_s = Math.ceil(start_s / step_s) * step_s; time_s <= start_s + length_s; time_s += step_s) {
    const x = Math.round(axis.px(time_s)) + 0.5;
    pen.strokeStyle = palette.faint;
    pen.beginPath();
    pen.moveTo(x, RULER_PX);
    pen.lineTo(x, height_px);
    pen.stroke();
    pen.fillStyle = palette.quiet;
    if (x + LABEL_PX < axis.left_px + axis.width_px) {
      pen.fillText(`${String(Number(time_s.toFixed(2)))} s`, x + 2, RULER_PX / 2);
    }
  }
}

/**
 * @param {Pen} pen
 * @param {Picture} picture
 * @param {PlacedRow} placedRow
 */
function drawRow(pen, picture, placedRow) {
  if (placedRow.row.kind === "wave") {
    drawWave(pen, picture, placedRow);
  } else if (placedRow.row.kind === "voice") {
    drawVoice(pen, picture, placedRow);
  }
  for (const item of placedRow.row.items) {
    drawItem(pen, picture, placedRow, item);
  }
}

/**
 * @param {Pen} pen
 * @param {Picture} picture
 * @param {PlacedRow} placedRow
 * @param {Item} item
 */
function drawItem(pen, picture, placedRow, item) {
  const { axis, palette, selected } = picture;
  const { left, top, width, height } = box(placedRow, item, axis);
  if (left > axis.left_px + axis.width_px || left + width < axis.left_px) {
    return;
  }
  pen.globalAlpha = item.kept ? 1 : FAINT;
  pen.fillStyle = palette.rows[placedRow.row.name] ?? palette.faint;
  pen.fillRect(left, top, width, height);
  for (const { name, start_s, end_s } of item.phases) {
    pen.fillStyle = PHASE_COLOURS[name];
    pen.fillRect(axis.px(start_s), top + height - 5, axis.px(end_s) - axis.px(start_s), 5);
  }
  drawMarks(pen, picture, item, top, height);
  drawName(pen, picture, item, { left, top, width, height });
  pen.globalAlpha = 1;
  if (selected === item.id) {
    pen.strokeStyle = palette.focus;
    pen.lineWidth = 2;
    pen.strokeRect(left, top, width, height);
    pen.lineWidth = 1;
  }
}

/**
 * @param {Pen} pen
 * @param {Picture} picture
 * @param {Item} item
 * @param {number} top
 * @param {number} height
 */
function drawMarks(pen, { axis, palette }, { marks }, top, height) {
  pen.fillStyle = palette.ink;
  for (const [mark, time_s] of marks) {
    pen.fillRect(axis.px(time_s) - 0.5, top, mark === "stroke" ? 2 : 1, height);
  }
}

/**
 * An item's name, as much of it as fits.
 *
 * @param {Pen} pen
 * @param {Picture} picture
 * @param {Item} item
 * @param {Readonly<{ left: number, top: number, width: number, height: number }>} place
 */
function drawName(pen, { axis, palette, badges }, { id, label }, { left, top, width, height }) {
  const from = Math.max(left, axis.left_px) + 3;
  const room = left + width - from - 2;
  if (room < 7) {
    return;
  }
  pen.save();
  pen.beginPath();
  pen.rect(from - 2, top, room + 3, height);
  pen.clip();
  pen.fillStyle = palette.ink;
  pen.fillText(badges[id] ? `${label} ${badges[id]}` : label, from, top + height / 2);
  pen.restore();
}

/**
 * @param {Pen} pen
 * @param {Picture} picture
 */
function drawLabels(pen, { rows, palette, height_px }) {
  pen.fillStyle = palette.panel;
  pen.fillRect(0, 0, LABELS_PX - 2, height_px);
  pen.fillStyle = palette.quiet;
  for (const { row, top_px } of rows) {
    pen.fillText(row.name, 6, top_px + LANE_PX / 2);
  }
}
