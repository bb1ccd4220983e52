/** Draws the timeline: its ruler, its rows with their signals, items and names. Colours are the page's. */

import { drawItem, isSpoken } from "./drawing_items.js";
import { drawSideBySide } from "./item_names.js";
import { LABELS_PX, RULER_PX } from "./layout.js";
import { drawVoice, drawWave } from "./signals.js";

/** @import { Axis } from "./axis.js" */
/** @import { Palette } from "./palette.js" */
/** @import { PlacedRow } from "./layout.js" */
/** @import { Signals } from "./signals.js" */

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
  if (!folded) {
    SIGNALS[row.kind]?.(pen, picture, placedRow);
  }
  for (const item of row.items) {
    drawItem(pen, picture, placedRow, item);
  }
  if (!folded && isSpoken(row)) {
    drawSideBySide(pen, picture, placedRow);
  }
}

/** What lies below the items of a row, by its kind. @type {Readonly<Record<string, typeof drawWave>>} */
const SIGNALS = Object.freeze({ wave: drawWave, voice: drawVoice });
