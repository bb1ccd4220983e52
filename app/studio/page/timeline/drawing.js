/** Draws the timeline: rows, items with their phases and marks, what is selected. Colours are the page's. */

import { drawSideBySide, drawSpilling } from "./item_names.js";
import { box, LABELS_PX, RULER_PX } from "./layout.js";
import { PHASE_COLOURS } from "./phases.js";
import { drawVoice, drawWave } from "./signals.js";

/** @import { Axis } from "./axis.js" */
/** @import { Palette } from "./palette.js" */
/** @import { PlacedRow } from "./layout.js" */
/** @import { Signals } from "./signals.js" */
/** @import { Item } from "./tracks.js" */

/**
 * Everything that a picture of the timeline depends on. `badges` are short texts behind items' names, by id; `marked` are
 * selected as well; `differing` are not in the version beside this one; at `snap_s` something snaps.
 *
 * @typedef {object} Picture
 * @property {readonly PlacedRow[]} rows
 * @property {Axis} axis
 * @property {Palette} palette
 * @property {Signals} signals
 * @property {string | null} selected
 * @property {readonly string[]} marked
 * @property {ReadonlySet<string>} differing
 * @property {number | null} snap_s
 * @property {readonly [number, number] | null} loop
 * @property {Readonly<Record<string, string>>} badges
 * @property {number} height_px
 */

/** @typedef {CanvasRenderingContext2D} Pen */

const TICKS_S = [0.05, 0.1, 0.25, 0.5, 1, 2, 5, 10, 30, 60];
const NARROWEST_TICK_PX = 55;
const LABEL_PX = 20;
const FAINT = 0.45;
const STRIP_PX = 9;
const TICK_PX = 4;

/** @typedef {ReturnType<typeof box>} Place */

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
  drawSnap(pen, picture);
  pen.fillStyle = palette.panel;
  pen.fillRect(0, 0, LABELS_PX - 2, height_px);
}

/**
 * Where what is dragged snaps to.
 *
 * @param {Pen} pen
 * @param {Picture} picture
 */
function drawSnap(pen, { axis, palette, snap_s, height_px }) {
  if (snap_s !== null) {
    pen.fillStyle = palette.focus;
    pen.fillRect(axis.px(snap_s) - 0.5, 0, 1, height_px);
    pen.fillText("⇥", axis.px(snap_s) + 3, RULER_PX / 2);
  }
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
  const { row, folded } = placedRow;
  if (row.kind === "wave" && !folded) {
    drawWave(pen, picture, placedRow);
  } else if (row.kind === "voice" && !folded) {
    drawVoice(pen, picture, placedRow);
  }
  for (const item of row.items) {
    drawItem(pen, picture, placedRow, item);
  }
  if (!folded && (row.kind === "wave" || row.name === "phones")) {
    drawSideBySide(pen, picture, placedRow);
  }
}

/**
 * @param {Pen} pen
 * @param {Picture} picture
 * @param {PlacedRow} placedRow
 * @param {Item} item
 */
function drawItem(pen, picture, placedRow, item) {
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
  if (!placedRow.folded && placedRow.row.kind === "items" && placedRow.row.name !== "phones") {
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
