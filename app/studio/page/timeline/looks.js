/** How the timeline is looked at: which rows are folded, how high they are, what of it is shown; kept in this browser. */

import { slice } from "../state/slice.js";

/** @import { Store } from "../state/store.js" */

/**
 * `heights` are shares of a row's usual height, by its name; `alternatives` are what gave way to something else; `list` is
 * the list beside the rows; `ripple` has what comes later in a row move along.
 *
 * @typedef {object} Looks
 * @property {Readonly<Record<string, boolean>>} folded
 * @property {Readonly<Record<string, number>>} heights
 * @property {boolean} alternatives
 * @property {boolean} list
 * @property {boolean} ripple
 */

const KEY = "understudy-timeline";
const [LOWEST, HIGHEST] = [0.7, 3];
const WIDE_PX = 1200;

export const LOOKS = slice(/** @type {Readonly<Looks>} */ ({ folded: { phones: true, visemes: true }, heights: {}, alternatives: false, list: true, ripple: false }));

/** @param {Store} store */
export function keepLooks(store) {
  const kept = JSON.parse(localStorage.getItem(KEY) ?? "null");
  store.patch(LOOKS, kept ?? { list: innerWidth >= WIDE_PX });
  store.watch(LOOKS, (looks) => localStorage.setItem(KEY, JSON.stringify(looks)));
}

/**
 * @param {Store} store
 * @param {"alternatives" | "list" | "ripple"} look
 */
export function toggleLook(store, look) {
  store.patch(LOOKS, { [look]: !store.get(LOOKS)[look] });
}

/**
 * @param {Store} store
 * @param {string} row
 */
export function toggleRow(store, row) {
  const { folded } = store.get(LOOKS);
  store.patch(LOOKS, { folded: { ...folded, [row]: !folded[row] } });
}

/**
 * @param {Store} store
 * @param {string} row
 * @param {number} share of its usual height
 */
export function resizeRow(store, row, share) {
  const { heights } = store.get(LOOKS);
  store.patch(LOOKS, { heights: { ...heights, [row]: Math.min(HIGHEST, Math.max(LOWEST, share)) } });
}
