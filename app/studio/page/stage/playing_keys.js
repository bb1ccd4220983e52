/**
 * The keys that play the line while it is seen, where nothing else takes them: Space plays, L plays on and faster, K
 * pauses, J goes back; the arrows step a frame, with Shift half a second, Home and End go to the ends; I and O (or [ and ])
 * begin and end at the playhead what Loop repeats.
 */

import { VIEW } from "../frame/views.js";
import { PERFORMED, PLAYBACK, TIME_S } from "../state/performed.js";

/** @import { Store } from "../state/store.js" */

export const FRAME_S = 1 / 60;
const LARGE_STEP_S = 0.5;
const FASTEST = 2;
const TAKERS = "input, textarea, select, button, summary, a, dialog";

/** @param {Store} store */
export function followPlayingKeys(store) {
  document.addEventListener("keydown", (event) => onKey(event, store));
}

/**
 * Stops when another view is shown: what sounds is seen.
 *
 * @param {Store} store
 */
export function pauseWhereUnseen(store) {
  store.watch(VIEW, (view) => {
    if (view !== "line" && store.get(PLAYBACK).playing) {
      store.patch(PLAYBACK, { playing: false });
    }
  });
}

/** @param {Store} store */
export function togglePlaying(store) {
  const { playing, speed } = store.get(PLAYBACK);
  store.patch(PLAYBACK, { playing: !playing, speed: Math.abs(speed) });
}

/**
 * @param {Store} store
 * @param {number} by_s
 */
export function stepBy(store, by_s) {
  const [start_s, end_s] = wholeLine(store);
  store.patch(PLAYBACK, { playing: false });
  store.set(TIME_S, Math.min(end_s, Math.max(start_s, store.get(TIME_S) + by_s)));
}

/**
 * @param {Store} store
 * @returns {[number, number]}
 */
export function wholeLine(store) {
  const line = store.get(PERFORMED);
  return [0, line ? line.performance.lead_in_s + line.performance.audio.duration_s : 0];
}

/**
 * @param {Store} store
 * @param {0 | 1} end of the stretch that is repeated, which is put where the playhead is
 */
function endLoopHere(store, end) {
  const stretch = [...(store.get(PLAYBACK).loop ?? wholeLine(store))];
  stretch[end] = store.get(TIME_S);
  const [start_s = 0, end_s = 0] = stretch;
  if (start_s < end_s) {
    store.patch(PLAYBACK, { loop: [start_s, end_s] });
  }
}

/**
 * Plays on or back; again, it goes twice as fast. Backwards it is silent.
 *
 * @param {Store} store
 * @param {1 | -1} way
 */
function shuttle(store, way) {
  const { playing, speed } = store.get(PLAYBACK);
  const goesOn = playing && Math.sign(speed) === way;
  store.patch(PLAYBACK, { playing: true, speed: way * (goesOn ? Math.min(FASTEST, 2 * Math.abs(speed)) : 1) });
}

/** @type {Readonly<Record<string, (store: Store, isLarge: boolean) => void>>} */
const KEYS = Object.freeze({
  " ": togglePlaying,
  ArrowLeft: (store, isLarge) => stepBy(store, -(isLarge ? LARGE_STEP_S : FRAME_S)),
  ArrowRight: (store, isLarge) => stepBy(store, isLarge ? LARGE_STEP_S : FRAME_S),
  Home: (store) => stepBy(store, -Infinity),
  End: (store) => stepBy(store, Infinity),
  "[": (store) => endLoopHere(store, 0),
  "]": (store) => endLoopHere(store, 1),
  i: (store) => endLoopHere(store, 0),
  o: (store) => endLoopHere(store, 1),
  j: (store) => shuttle(store, -1),
  k: (store) => store.patch(PLAYBACK, { playing: false, speed: 1 }),
  l: (store) => shuttle(store, 1),
});

/**
 * @param {KeyboardEvent} event
 * @param {Store} store
 */
function onKey(event, store) {
  const act = KEYS[event.key.length === 1 ? event.key.toLowerCase() : event.key];
  if (act && !isTaken(event) && store.get(VIEW) === "line" && store.get(PERFORMED)) {
    event.preventDefault();
    act(store, event.shiftKey);
  }
}

/** @param {KeyboardEvent} event */
function isTaken({ defaultPrevented, target, ctrlKey, metaKey, altKey }) {
  const isForControl = target instanceof Element && target.closest(TAKERS) !== null;
  return defaultPrevented || isForControl || ctrlKey || metaKey || altKey;
}
