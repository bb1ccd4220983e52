/**
 * What the pointer does on the timeline. Clicking an item selects it, with Shift or Ctrl beside others; dragging one, or one of its marks, tells DRAG and
 * nothing else: whoever changes lines (`changes/`) watches DRAG and makes an edit of it. The ruler moves the playhead;
 * dragging over the words, but for their edges, chooses what is repeated. What is dragged snaps (snapping.js) unless Alt is
 * held.
 */

import { PERFORMED, PLAYBACK, SELECTION, TIME_S } from "../state/performed.js";
import { selectAndSeek } from "../state/selecting.js";
import { slice } from "../state/slice.js";
import { snapped, targetsOf } from "./snapping.js";

/** @import { Store } from "../state/store.js" */
/** @import { Axis } from "./axis.js" */
/** @import { Hit } from "./layout.js" */
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
 * @typedef {Readonly<{ selected: string | null, marked: readonly string[], time_s: number }>} Before
 * @typedef {{ hit: Hit, x: number, from_s: number, far: boolean, isMore: boolean, before: Before }} Held
 */

export const DRAG = slice(/** @type {Drag | null} */ (null));

/** What is selected beside SELECTION, by ids. */
export const MARKED = slice(/** @type {readonly string[]} */ ([]));

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
 * @param {{ axis: () => Axis | null, hit: (x: number, y: number) => Hit }} drawn
 */
export function followPointer(canvas, store, { axis, hit }) {
  /** @type {Held | null} */
  let held = null;
  const time_s = (/** @type {PointerEvent} */ event) => axis()?.time_s(event.offsetX) ?? 0;
  canvas.addEventListener("pointerdown", (event) => {
    canvas.setPointerCapture(event.pointerId);
    const isMore = event.shiftKey || event.ctrlKey || event.metaKey;
    const before = { selected: store.get(SELECTION), marked: store.get(MARKED), time_s: store.get(TIME_S) };
    held = { hit: hit(event.offsetX, event.offsetY), x: event.offsetX, from_s: time_s(event), far: false, isMore, before };
    press(store, held);
  });
  canvas.addEventListener("pointermove", (event) => {
    if (held) {
      held.far ||= Math.abs(event.offsetX - held.x) > LEAST_PX;
      drag(store, held, snappedTime_s(store, held, time_s(event), event.altKey ? null : axis()), false);
    } else {
      canvas.style.cursor = cursorOver(hit(event.offsetX, event.offsetY));
      canvas.title = titleOf(hit(event.offsetX, event.offsetY));
    }
  });
  canvas.addEventListener("pointerup", (event) => {
    if (held) {
      const to_s = snappedTime_s(store, held, time_s(event), event.altKey ? null : axis());
      drag(store, held, to_s, true);
      release(store, held, to_s);
      held = null;
    }
  });
  canvas.addEventListener("pointercancel", () => {
    if (held) {
      cancel(store, held);
      held = null;
    }
  });
}

/**
 * @param {Store} store
 * @param {Held} held
 */
function press(store, { hit: { row, item }, from_s, isMore }) {
  const isAmong = item !== null && [store.get(SELECTION), ...store.get(MARKED)].includes(item.id);
  const isBeside = isMore && item !== null && mark(store, item.id);
  if (row === "ruler") {
    store.set(TIME_S, Math.max(0, from_s));
  } else if (!isBeside && !isAmong) {
    select(store, item);
  }
}

/**
 * Of several that are selected the one that was pressed is, unless all were dragged; the playhead goes with what was.
 *
 * @param {Store} store
 * @param {Held} held
 * @param {number} to_s
 */
function release(store, { hit: { row, item, mark: name }, from_s, far, isMore }, to_s) {
  store.set(SNAP_S, null);
  if (row === "ruler" || !item) {
    return;
  }
  if (!far && !isMore) {
    select(store, item);
  } else if (far && item.marks.length > 0 && row !== "words" && !store.get(PLAYBACK).playing) {
    store.set(TIME_S, Math.max(0, (leading_s(item, name) ?? from_s) + to_s - from_s));
  }
}

/**
 * The finger scrolls: nothing was meant to be pressed.
 *
 * @param {Store} store
 * @param {Held} held
 */
function cancel(store, { before }) {
  store.set(DRAG, null);
  store.set(SNAP_S, null);
  store.set(SELECTION, before.selected);
  store.set(MARKED, before.marked);
  store.set(TIME_S, before.time_s);
}

/**
 * @param {Store} store
 * @param {Item | null} item
 */
function select(store, item) {
  store.set(MARKED, []);
  selectAndSeek(store, item?.id ?? null);
}

/**
 * Selects something beside what is selected, or no longer; whether there is something to be beside.
 *
 * @param {Store} store
 * @param {string} id
 */
function mark(store, id) {
  const [before, marked] = [store.get(SELECTION), store.get(MARKED)];
  const isBeside = before !== null && before !== id;
  if (isBeside) {
    store.set(MARKED, marked.includes(id) ? marked.filter((each) => each !== id) : [...marked, id]);
  }
  return isBeside;
}

/**
 * The time that is dragged to, moved so that the item or its mark snaps.
 *
 * @param {Store} store
 * @param {Held} held
 * @param {number} to_s
 * @param {Axis | null} axis null where nothing is to snap
 */
function snappedTime_s(store, { hit: { item, mark: name, row }, from_s, far }, to_s, axis) {
  const line = store.get(PERFORMED);
  const isMoved = far && row !== "words";
  if (!line || !axis || !item || !isMoved) {
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
