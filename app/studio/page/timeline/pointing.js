/**
 * What the pointer does on the timeline. Clicking an item selects it, with Shift or Ctrl beside others; dragging one, or one of its marks, tells DRAG and
 * nothing else: whoever changes lines (`changes/`) watches DRAG and makes an edit of it. The ruler moves the playhead;
 * dragging over the words, but for their edges, chooses what is repeated. What is dragged snaps (snapping.js) unless Alt is
 * held.
 */

import { PERFORMED, PLAYBACK, TIME_S } from "../state/performed.js";
import { slice } from "../state/slice.js";
import { press, selectAgain, selectAlone, selectedNow } from "./selecting.js";
import { snapped, targetsOf } from "./snapping.js";

/** @import { Store } from "../state/store.js" */
/** @import { Axis } from "./axis.js" */
/** @import { Hit } from "./layout.js" */
/** @import { Selected } from "./selecting.js" */
/** @import { Item } from "./tracks.js" */

/**
 * An item that is dragged, or one of its marks (null: all of it), from a time to another; `ended` when it is let go.
 *
 * @typedef {Readonly<{ id: string, mark: string | null, from_s: number, to_s: number, ended: boolean }>} Drag
 */

/**
 * What is pressed, from where, whether it was moved `far`, whether what was selected stays so (`isMore`), and how it was
 * `before`.
 *
 * @typedef {{ hit: Hit, x: number, from_s: number, far: boolean, isMore: boolean, before: Selected }} Held
 */

export const DRAG = slice(/** @type {Drag | null} */ (null));

/** Where what is dragged has snapped to, seconds; null where it has not. */
export const SNAP_S = slice(/** @type {number | null} */ (null));

/** Short texts behind items' names, by id, such as that one is locked; whoever knows such things sets it. */
export const BADGES = slice(/** @type {Readonly<Record<string, string>>} */ ({}));

const LEAST_PX = 3;

/**
 * Follows the pointer on a canvas, which is drawn along `axis()`.
 *
 * @param {HTMLCanvasElement} canvas
 * @param {Store} store
 * @param {{ axis: () => Axis | null, hit: (event: PointerEvent) => Hit }} drawn
 */
export function followPointer(canvas, store, { axis, hit }) {
  /** @type {Held | null} */
  let held = null;
  const time_s = (/** @type {PointerEvent} */ event) => axis()?.time_s(event.offsetX) ?? 0;
  const to_s = (/** @type {PointerEvent} */ event, /** @type {Held} */ now) =>
    snappedTime_s(store, now, time_s(event), event.altKey ? null : axis());
  canvas.addEventListener("pointerdown", (event) => {
    canvas.setPointerCapture(event.pointerId);
    held = begun(store, event, { hit: hit(event), from_s: time_s(event) });
  });
  canvas.addEventListener("pointermove", (event) => {
    if (held) {
      held.far ||= Math.abs(event.offsetX - held.x) > LEAST_PX;
      drag(store, held, to_s(event, held), false);
    } else {
      hover(canvas, hit(event));
    }
  });
  canvas.addEventListener("pointerup", (event) => {
    held = held && ended(store, held, to_s(event, held));
  });
  canvas.addEventListener("pointercancel", () => {
    held = held && cancelled(store, held);
  });
}

/**
 * @param {Store} store
 * @param {PointerEvent} event
 * @param {{ hit: Hit, from_s: number }} pressed
 * @returns {Held}
 */
function begun(store, { offsetX, shiftKey, ctrlKey, metaKey }, { hit, from_s }) {
  const isMore = shiftKey || ctrlKey || metaKey;
  const held = { hit, from_s, x: offsetX, far: false, isMore, before: selectedNow(store) };
  if (hit.row === "ruler") {
    store.set(TIME_S, Math.max(0, from_s));
  } else {
    press(store, hit, isMore);
  }
  return held;
}

/**
 * What is let go is where it was dragged to, and the playhead with it; of several that are selected the one that was only
 * pressed is.
 *
 * @param {Store} store
 * @param {Held} held
 * @param {number} to_s
 */
function ended(store, held, to_s) {
  const { hit, from_s, far, isMore } = held;
  const at_s = hit.item ? leading_s(hit.item, hit.mark) : undefined;
  drag(store, held, to_s, true);
  store.set(SNAP_S, null);
  if (!far && !isMore && hit.item) {
    selectAlone(store, hit.item);
  } else if (isDragged(held) && at_s !== undefined && !store.get(PLAYBACK).playing) {
    store.set(TIME_S, Math.max(0, at_s + to_s - from_s));
  }
  return null;
}

/** @param {Held} held */
function isDragged({ hit, far }) {
  return far && hit.row !== "ruler" && hit.row !== "words";
}

/**
 * The finger scrolls: nothing was meant to be pressed.
 *
 * @param {Store} store
 * @param {Held} held
 */
function cancelled(store, { before }) {
  store.set(DRAG, null);
  store.set(SNAP_S, null);
  selectAgain(store, before);
  return null;
}

/**
 * The time that is dragged to, moved so that the item or its mark snaps.
 *
 * @param {Store} store
 * @param {Held} held
 * @param {number} to_s
 * @param {Axis | null} axis null where nothing is to snap
 */
function snappedTime_s(store, held, to_s, axis) {
  const { hit: { item, mark: name }, from_s } = held;
  const line = store.get(PERFORMED);
  if (!line || !axis || !item || !isDragged(held)) {
    return to_s;
  }
  const at_s = leading_s(item, name) ?? from_s;
  const snap_s = snapped(at_s + to_s - from_s, targetsOf(line.performance, item.id, store.get(TIME_S)), axis);
  store.set(SNAP_S, snap_s);
  return snap_s === null ? to_s : from_s + snap_s - at_s;
}

/**
 * When the mark is that is dragged; of a whole movement its stroke, else its beginning.
 *
 * @param {Item} item
 * @param {string | null} name
 */
function leading_s({ marks }, name) {
  const wanted = name ?? "stroke";
  return (marks.find(([mark]) => mark === wanted) ?? marks[0])?.[1];
}

/**
 * @param {Store} store
 * @param {Held} held
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

/**
 * @param {HTMLCanvasElement} canvas
 * @param {Hit} found
 */
function hover(canvas, found) {
  canvas.style.cursor = cursorOver(found);
  canvas.title = titleOf(found);
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
  return item ? [item.label, item.technical, mark && `mark: ${mark}`, item.why].filter(Boolean).join("\n") : "";
}
