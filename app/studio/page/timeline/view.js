/** The timeline's canvas with its playhead, drawn anew whenever what it shows has changed. */

import { PERFORMED, PLAYBACK, SELECTION, TIME_S } from "../state/performed.js";
import { Axis, scrolled, STRETCH, within, zoomed } from "./axis.js";
import { draw } from "./drawing.js";
import { Gutter } from "./gutter.js";
import { FINGER_LANE_PX, FINGER_NEAR_PX, heightOf, hitAt, LABELS_PX, placed } from "./layout.js";
import { LOOKS } from "./looks.js";
import { paletteOf } from "./palette.js";
import { BADGES, followPointer, SNAP_S } from "./pointing.js";
import { MARKED } from "./selecting.js";
import { PEAKS } from "./signals.js";
import { DIFFERING, OTHERS } from "./compared.js";
import { rowsOf } from "./tracks.js";

/** @import { Store } from "../state/store.js" */
/** @import { PlacedRow } from "./layout.js" */

/** How much less is seen after a step of zooming. */
export const ZOOM = 1.4;
const RIGHT_PX = 10;
/** How much more than what is selected is seen when it is zoomed to. */
const AROUND = 2.5;

/** Shows the line that was performed last. */
export class Timeline {
  /** @type {readonly PlacedRow[]} */
  #rows = [];
  gutter;
  #whole_s = 1;
  /** @type {Axis | null} */
  #axis = null;
  #canvas;
  #playhead;
  #store;

  /**
   * @param {HTMLCanvasElement} canvas
   * @param {HTMLElement} playhead
   * @param {Store} store
   */
  constructor(canvas, playhead, store) {
    this.#canvas = canvas;
    this.#playhead = playhead;
    this.#store = store;
    this.gutter = new Gutter(store);
    for (const of of [SELECTION, STRETCH, PLAYBACK, PEAKS, BADGES, MARKED, SNAP_S, DIFFERING]) {
      store.watch(/** @type {typeof SELECTION} */ (of), () => this.draw());
    }
    store.watch(TIME_S, () => this.#movePlayhead());
    followPointer(canvas, store, { axis: () => this.#axis, hit: (event) => this.#hit(event) });
    canvas.addEventListener("wheel", (event) => this.#onWheel(event), { passive: false });
  }

  /** Takes over what was performed last. */
  take() {
    const line = this.#store.get(PERFORMED);
    const looks = this.#store.get(LOOKS);
    const rows = line ? rowsOf(line.performance, { alternatives: looks.alternatives, others: this.#store.get(OTHERS) }) : [];
    this.#rows = placed(rows, looks, matchMedia("(pointer: coarse)").matches ? FINGER_LANE_PX : 0);
    this.gutter.show(this.#rows);
    this.#playhead.style.height = `${String(heightOf(this.#rows))}px`;
    const ends_s = rows.flatMap(({ items }) => items.map(({ end_s }) => end_s));
    const { lead_in_s, audio } = line?.performance ?? { lead_in_s: 0, audio: { duration_s: 1 } };
    this.#whole_s = Math.max(lead_in_s + audio.duration_s, ...ends_s);
    this.draw();
    return rows;
  }

  draw() {
    const line = this.#store.get(PERFORMED);
    this.#canvas.hidden = this.#playhead.hidden = line === null;
    const pen = this.#canvas.getContext("2d");
    const width_px = this.#canvas.parentElement?.clientWidth ?? 0;
    if (!line || !pen || width_px <= LABELS_PX + RIGHT_PX) {
      return;
    }
    const height_px = heightOf(this.#rows);
    size(this.#canvas, width_px, height_px);
    this.#canvas.dataset["stretch"] = Object.values(this.#stretch).map((seconds) => seconds.toFixed(3)).join(" ");
    this.#axis = new Axis(this.#stretch, LABELS_PX, width_px - LABELS_PX - RIGHT_PX);
    pen.setTransform(devicePixelRatio, 0, 0, devicePixelRatio, 0, 0);
    draw(pen, {
      rows: this.#rows,
      axis: this.#axis,
      palette: paletteOf(this.#canvas),
      signals: { peaks: this.#store.get(PEAKS), contours: line.contours, performance: line.performance },
      selected: this.#store.get(SELECTION),
      marked: this.#store.get(MARKED),
      differing: this.#store.get(DIFFERING),
      snap_s: this.#store.get(SNAP_S),
      loop: this.#store.get(PLAYBACK).loop,
      badges: this.#store.get(BADGES),
      height_px,
    });
    this.#movePlayhead();
  }

  /** @param {number} factor */
  zoom(factor) {
    const { start_s, length_s } = this.#stretch;
    const now_s = this.#store.get(TIME_S);
    const isSeen = now_s >= start_s && now_s <= start_s + length_s;
    this.#store.set(STRETCH, zoomed(this.#stretch, factor, isSeen ? now_s : start_s + length_s / 2, this.#whole_s));
  }

  /** @param {number} share of what is seen */
  scroll(share) {
    this.#store.set(STRETCH, scrolled(this.#stretch, share * this.#stretch.length_s, this.#whole_s));
  }

  whole() {
    this.#store.set(STRETCH, null);
  }

  /** Shows what is selected, with some of what is around it. */
  selection() {
    const id = this.#store.get(SELECTION);
    const item = this.#rows.flatMap(({ row }) => row.items).find((each) => each.id === id);
    if (item) {
      const length_s = AROUND * (item.end_s - item.start_s);
      this.#store.set(STRETCH, within({ start_s: (item.start_s + item.end_s - length_s) / 2, length_s }, this.#whole_s));
    }
  }

  get #stretch() {
    return within(this.#store.get(STRETCH) ?? { start_s: 0, length_s: Infinity }, this.#whole_s);
  }

  /** @param {PointerEvent} event */
  #hit({ offsetX, offsetY, pointerType }) {
    const near_px = pointerType === "touch" ? FINGER_NEAR_PX : undefined;
    return this.#axis ? hitAt(this.#rows, this.#axis, offsetX, offsetY, near_px) : { row: "", item: null, mark: null };
  }

  /** @param {WheelEvent} event */
  #onWheel(event) {
    const along_px = event.shiftKey ? event.deltaY : event.deltaX;
    if (event.ctrlKey && this.#axis) {
      event.preventDefault();
      const still_s = this.#axis.time_s(event.offsetX);
      this.#store.set(STRETCH, zoomed(this.#stretch, event.deltaY < 0 ? 1 / ZOOM : ZOOM, still_s, this.#whole_s));
    } else if (along_px !== 0 && this.#axis) {
      event.preventDefault();
      this.scroll(along_px / this.#axis.width_px);
    }
  }

  #movePlayhead() {
    const time_s = this.#store.get(TIME_S);
    const { start_s, length_s } = this.#stretch;
    if (this.#store.get(PLAYBACK).playing && time_s > start_s + length_s) {
      this.scroll(1);
    }
    this.#playhead.style.transform = `translateX(${String(this.#axis?.px(time_s) ?? 0)}px)`;
    this.#playhead.hidden = this.#canvas.hidden || time_s < start_s || time_s > start_s + length_s;
  }
}

/**
 * @param {HTMLCanvasElement} canvas
 * @param {number} width_px
 * @param {number} height_px
 */
function size(canvas, width_px, height_px) {
  const [width, height] = [Math.floor(width_px * devicePixelRatio), Math.floor(height_px * devicePixelRatio)];
  if (canvas.width !== width || canvas.height !== height) {
    canvas.width = width;
    canvas.height = height;
    canvas.style.height = `${String(height_px)}px`;
  }
}
