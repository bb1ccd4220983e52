/** What is pressed on the timeline is selected, with Shift or Ctrl beside what is; a finger that scrolls selects nothing. */

import { SELECTION, TIME_S } from "../state/performed.js";
import { selectAndSeek } from "../state/selecting.js";
import { slice } from "../state/slice.js";

/** @import { Store } from "../state/store.js" */
/** @import { Hit } from "./layout.js" */
/** @import { Item } from "./tracks.js" */

/** What is selected beside SELECTION, by ids. */
export const MARKED = slice(/** @type {readonly string[]} */ ([]));

/** @typedef {Readonly<{ selected: string | null, marked: readonly string[], time_s: number }>} Selected */

/**
 * @param {Store} store
 * @returns {Selected}
 */
export function selectedNow(store) {
  return { selected: store.get(SELECTION), marked: store.get(MARKED), time_s: store.get(TIME_S) };
}

/**
 * @param {Store} store
 * @param {Selected} before
 */
export function selectAgain(store, before) {
  store.set(SELECTION, before.selected);
  store.set(MARKED, before.marked);
  store.set(TIME_S, before.time_s);
}

/**
 * Selects what is pressed, unless it is among what is selected: then all of it may be dragged.
 *
 * @param {Store} store
 * @param {Hit} hit
 * @param {boolean} isMore whether what was selected stays so
 */
export function press(store, { item }, isMore) {
  const isAmong = item !== null && [store.get(SELECTION), ...store.get(MARKED)].includes(item.id);
  const isBeside = isMore && item !== null && mark(store, item.id);
  if (!isBeside && !isAmong) {
    selectAlone(store, item);
  }
}

/**
 * @param {Store} store
 * @param {Item | null} item
 */
export function selectAlone(store, item) {
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
