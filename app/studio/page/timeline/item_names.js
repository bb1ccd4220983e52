/** Draws the names of items so that they can be read: whole where there is room, shortened where there is none. */

import { box } from "./layout.js";

/** @import { Pen, Picture } from "./drawing.js" */
/** @import { Place } from "./drawing_items.js" */
/** @import { PlacedRow } from "./layout.js" */
/** @import { Item } from "./tracks.js" */

const LEAST_PX = 10;
const NAME_PX = 15;
const INSET_PX = 4;
const APART_PX = 3;

/**
 * An item's name, on beyond its end as far as nothing else is there.
 *
 * @param {Pen} pen
 * @param {Picture} picture
 * @param {Item} item
 * @param {Place} place
 */
export function drawSpilling(pen, { axis, palette, badges }, { id, label, next_s, phases }, { left, top, width, height }) {
  const from = Math.max(left, axis.left_px) + INSET_PX;
  const right = Math.max(left + width, Math.min(axis.px(next_s), axis.left_px + axis.width_px));
  const told = badges[id] ? `${label} (${badges[id]})` : label;
  const text = shortened(told, right - from - 2, (each) => pen.measureText(each).width);
  pen.fillStyle = palette.ink;
  pen.fillText(text, from, phases.length > 0 ? top + NAME_PX / 2 + 1 : top + height / 2);
}

/**
 * The names of a row in two lines, so that short items have room: each on the first line that is free where it begins.
 *
 * @param {Pen} pen
 * @param {Picture} picture
 * @param {PlacedRow} placedRow
 */
export function drawSideBySide(pen, { axis, palette }, placedRow) {
  const width = (/** @type {string} */ text) => pen.measureText(text).width;
  const right_px = axis.left_px + axis.width_px;
  const seen = placedRow.row.items.filter((item) => axis.px(item.end_s) > axis.left_px && axis.px(item.start_s) < right_px);
  pen.fillStyle = palette.ink;
  pen.font = placedRow.row.name === "phones" ? "10px system-ui, sans-serif" : "12px system-ui, sans-serif";
  const texts = seen.map((item) => ({ left: Math.max(axis.left_px, axis.px(item.start_s)) + 2, text: item.label }));
  const [first] = seen;
  const { top, height } = first ? box(placedRow, first, axis) : { top: 0, height: 0 };
  for (const { left, line, text } of inLines(texts, width)) {
    pen.fillText(text, left, top + height * (line === 0 ? 0.28 : 0.76));
  }
  pen.font = "11px system-ui, sans-serif";
}

/**
 * Texts on two lines without one over another: each may go on above or below the next, up to the one after that.
 *
 * @param {readonly Readonly<{ left: number, text: string }>[]} texts from left to right
 * @param {(text: string) => number} width
 */
export function inLines(texts, width) {
  const free = [-Infinity, -Infinity];
  return texts.flatMap(({ left, text }, index) => {
    const line = (free[0] ?? 0) <= left ? 0 : 1;
    const room = (texts[index + 2]?.left ?? Infinity) - left - APART_PX;
    const shown = shortened(text, room, width);
    free[line] = left + width(shown) + APART_PX;
    return shown ? [{ left, line, text: shown }] : [];
  });
}

/**
 * As much of a text as there is room for, with an ellipsis where something is left out; nothing where it could not be read.
 *
 * @param {string} text
 * @param {number} room_px
 * @param {(text: string) => number} width
 */
export function shortened(text, room_px, width) {
  if (width(text) <= room_px) {
    return text;
  }
  for (let length = text.length - 1; length > 0 && room_px >= LEAST_PX; length--) {
    const short = `${text.slice(0, length).trimEnd()}…`;
    if (width(short) <= room_px) {
      return short;
    }
  }
  return "";
}
