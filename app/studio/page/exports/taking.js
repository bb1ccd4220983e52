/** How pictures of the stage are taken: at a time, at rest, as large as films are. */

import { PLAYBACK, SELECTION, TIME_S } from "../state/performed.js";

/** @import { Store } from "../state/store.js" */
/** @import { Screen } from "../stage/viewing.js" */

/** Tells how far something is, from 0 to 1; throws where it was given up. @typedef {(share: number) => void} Telling */

const FILM = Object.freeze({ width_px: 1920, height_px: 1080 });

/**
 * The stage at a time.
 *
 * @param {Store} store
 * @param {Screen} screen
 * @param {number} time_s
 * @returns {Promise<Blob>}
 */
export async function taken(store, { canvas, draw }, time_s) {
  store.set(TIME_S, time_s);
  draw();
  const picture = await new Promise((/** @type {(blob: Blob | null) => void} */ resolve) => canvas.toBlob(resolve, "image/png"));
  if (!picture) {
    throw new Error("the browser made no picture of the stage");
  }
  return picture;
}

/** Lets the browser draw the page and hear clicks, also where the page is not seen (unlike a timer). */
export function breath() {
  const { port1, port2 } = new MessageChannel();
  return new Promise((/** @type {(value: void) => void} */ resolve) => {
    port1.addEventListener("message", () => {
      port1.close();
      resolve();
    });
    port1.start();
    port2.postMessage(null);
  });
}

/**
 * Does something while nothing is played, and goes back to where the playhead was.
 *
 * @template Made
 * @param {Store} store
 * @param {() => Promise<Made>} act
 */
export async function resting(store, act) {
  const [time_s, selected] = [store.get(TIME_S), store.get(SELECTION)];
  store.patch(PLAYBACK, { playing: false });
  store.set(SELECTION, null);
  try {
    return await act();
  } finally {
    store.set(TIME_S, time_s);
    store.set(SELECTION, selected);
  }
}

/**
 * The same on a stage of the size of films.
 *
 * @template Made
 * @param {Store} store
 * @param {Screen} screen
 * @param {() => Promise<Made>} act
 */
export async function large(store, { fix, draw }, act) {
  fix(FILM);
  draw();
  try {
    return await resting(store, act);
  } finally {
    fix(null);
    draw();
  }
}

/**
 * @param {Store} store
 * @param {number} length_s
 * @param {Telling} tell
 */
export function playedToTheEnd(store, length_s, tell) {
  return new Promise((/** @type {(value: void) => void} */ resolve) => {
    const stopTelling = store.watch(TIME_S, (time_s) => tell(time_s / length_s));
    let isPlaying = false;
    const stop = store.watch(PLAYBACK, ({ playing }) => {
      if (isPlaying && !playing) {
        queueMicrotask(() => {
          stop();
          stopTelling();
          resolve();
        });
      }
      isPlaying = playing;
    });
  });
}
