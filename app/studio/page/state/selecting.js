/** What an author selects is looked at: the playhead goes to where it is done. */

import { PERFORMED, PLAYBACK, SELECTION, TIME_S } from "./performed.js";

/** @import { Store } from "./store.js" */
/** @import { Behavior, Performance } from "understudy-client" */

/**
 * @param {Store} store
 * @param {string | null} id
 */
export function selectAndSeek(store, id) {
  store.set(SELECTION, id);
  const line = store.get(PERFORMED);
  const time_s = line && id !== null ? timeOf(line.performance, id) : null;
  if (time_s !== null && !store.get(PLAYBACK).playing) {
    store.set(TIME_S, time_s);
  }
}

/**
 * Looks at a movement that is not of the line's own, such as one of another version.
 *
 * @param {Store} store
 * @param {Pick<Behavior, "sync">} behavior
 */
export function seekTo(store, { sync }) {
  store.set(TIME_S, momentOf(sync));
}

/**
 * When it is to be seen: at a movement's stroke, else in its middle, at the beginning of a word or function; null for
 * what has no time.
 *
 * @param {Performance} performance
 * @param {string} id
 */
export function timeOf({ behaviors, functions, words, visemes }, id) {
  const sync = behaviors.find((each) => each.id === id)?.sync;
  if (sync) {
    return momentOf(sync);
  }
  const [kind, number] = id.split(":");
  const spoken = { word: words, viseme: visemes.filter(({ label }) => label !== "sil") }[kind ?? ""]?.[Number(number)];
  return (spoken ?? functions.find((each) => each.id === id))?.start_s ?? null;
}

/** @param {Readonly<Record<string, number>>} sync */
function momentOf(sync) {
  const times_s = Object.values(sync);
  return sync["stroke"] ?? (Math.min(...times_s) + Math.max(...times_s)) / 2;
}
