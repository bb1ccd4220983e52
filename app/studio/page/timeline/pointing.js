/**
 * What the pointer does on the timeline. Clicking an item selects it; dragging one, or one of its marks, tells DRAG and
 * nothing else: whoever changes lines (`changes/`) watches DRAG and makes an edit of it. The ruler moves the playhead;
 * dragging over the words, but for their edges, chooses what is repeated.
 */

import { PLAYBACK, SELECTION, TIME_S } from "../state/performed.js";
import { slice } from "../state/slice.js";

/** @import { Store } from "../state/store.js" */
/** @import { Axis } from "./axis.js" */
/** @import { Hit } from "./layout.js" */

/**
 * An item that is dragged, or one of its marks (null: all of it), from a time to another; `ended` when it is let go.
 *
 * @typedef {Readonly<{ id: string, mark: string | null, from_s: number, to_s: number, ended: boolean }>} Drag
 */

export const DRAG = slice(/** @type {Drag | null} */ (null));

/** Short texts behind items' names, by id, such as that one is locked; whoever knows such things sets it. */
export const BADGES = slice(/** @type {Readonly<Record<string, string>>} */ ({}));

const LEAST_PX = 3;

/**
 * Follows the pointer on a canvas, which is drawn along `axis()`.
 *
 * @param {HTMLCanvasElement} canvas
 * @param {Store} store
 * @param {{ axis: () => Axis | null, hit: (x: number, y: number) => Hit }} drawn
 */
export function followPointer(canvas, store, { axis, hit }) {
  /** @type {{ hit: Hit, x: number, from_s: number, far: boolean } | null} */
  let held = null;
  const time_s = (/** @type {PointerEvent} */ event) => axis()?.time_s(event.offsetX) ?? 0;
  canvas.addEventListener("pointerdown", (event) => {
    canvas.setPointerCapture(event.pointerId);
    held = { hit: hit(event.offsetX, event.offsetY), x: event.offsetX, from_s: time_s(event), far: false };
    press(store, held.hit, held.from_s);
  });
  canvas.addEventListener("pointermove", (event) => {
    if (held) {
      held.far ||= Math.abs(event.offsetX - held.x) > LEAST_PX;
      drag(store, held, time_s(event), false);
    } else {
      canvas.style.cursor = cursorOver(hit(event.offsetX, event.offsetY));
      canvas.title = titleOf(hit(event.offsetX, event.offsetY));
    }
  });
  canvas.addEventListener("pointerup", (event) => {
    if (held) {
      drag(store, held, time_s(event), true);
      held = null;
    }
  });
}

/**
 * @param {Store} store
 * @param {Hit} hit
 * @param {number} time_s
 */
function press(store, { row, item }, time_s) {
  if (row === "ruler") {
    store.set(TIME_S, Math.max(0, time_s));
  } else {
    store.set(SELECTION, item?.id ?? null);
  }
}

/**
 * @param {Store} store
 * @param {{ hit: Hit, from_s: number, far: boolean }} held
 * @param {number} to_s
 * @param {boolean} ended
 */
function drag(store, { hit, from_s, far }, to_s, ended) {
  if (hit.row === "ruler") {
    store.set(TIME_S, Math.max(0, to_s));
  } else if (far && hit.row === "words" && !hit.mark) {
    store.patch(PLAYBACK, { loop: [Math.min(from_s, to_s), Math.max(from_s, to_s)] });
  } else if (far && hit.item && hit.item.marks.length > 0) {
    store.set(DRAG, { id: hit.item.id, mark: hit.mark, from_s, to_s, ended });
  }
}

/** @param {Hit} hit */
function cursorOver({ row, item, mark }) {
  if (row === "ruler" || mark) {
    return "ew-resize";
  }
  return item ? "pointer" : "default";
}

/** @param {Hit} hit */
function titleOf({ item, mark }) {
  return item ? [item.label, mark && `mark: ${mark}`, item.why].filter(Boolean).join("\n") : "";
}
