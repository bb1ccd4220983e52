/**
 * How finely the stage is drawn: all of it where that is quick. Where it is not, as without a graphics card, what moves is
 * coarse, and all of it is drawn as soon as it rests. The author may want one of both always.
 */

import { slice } from "../state/slice.js";

/** @import { Store } from "../state/store.js" */

/** @typedef {"automatic" | "high" | "low"} Quality */

/** Qualities with the names that people read. @type {readonly (readonly [Quality, string])[]} */
export const QUALITIES = Object.freeze([
  ["automatic", "Automatic"],
  ["high", "High"],
  ["low", "Low"],
]);
const KEY = "understudy-quality";

export const QUALITY = slice(/** @type {Quality} */ ("automatic"));

/** Frames take turns as this if they are longer or shorter: less than 22 a second are slow, more than 55 quick. */
const [SLOW_MS, QUICK_MS] = [45, 18];
const SHARE = 0.12;
/** What is longer is a pause. */
const LONGEST_MS = 1000;
const FIRST_WAIT_MS = 4000;

/** What was wanted when the page was open before. @returns {Quality} */
export function keptQuality() {
  const kept = localStorage.getItem(KEY);
  return QUALITIES.map(([quality]) => quality).find((quality) => quality === kept) ?? "automatic";
}

/**
 * Draws so from now on, also when the page is opened again.
 *
 * @param {Store} store
 * @param {Quality} quality
 */
export function keepQuality(store, quality) {
  localStorage.setItem(KEY, quality);
  store.set(QUALITY, quality);
}

/**
 * Whether what moves is to be coarse, from how long frames take. Coarse frames that are quick for a while have all of it
 * tried again; whenever that turns out to be slow, the next trial is twice as far away.
 */
export class Pace {
  #last_ms = -Infinity;
  #mean_ms = (SLOW_MS + QUICK_MS) / 2;
  #quick_ms = 0;
  #wait_ms = FIRST_WAIT_MS;

  /** @param {boolean} isSlow whether it is known to be slow */
  constructor(isSlow) {
    this.isCoarse = isSlow;
  }

  /** @param {number} now_ms when a frame is drawn in which something moved */
  frame(now_ms) {
    const passed_ms = now_ms - this.#last_ms;
    this.#last_ms = now_ms;
    if (passed_ms > LONGEST_MS) {
      return;
    }
    this.#mean_ms += SHARE * (passed_ms - this.#mean_ms);
    this.#quick_ms = this.#mean_ms < QUICK_MS ? this.#quick_ms + passed_ms : 0;
    if (!this.isCoarse && this.#mean_ms > SLOW_MS) {
      this.#turn(true);
    } else if (this.isCoarse && this.#quick_ms > this.#wait_ms) {
      this.#wait_ms *= 2;
      this.#turn(false);
    }
  }

  /** @param {boolean} isCoarse */
  #turn(isCoarse) {
    this.isCoarse = isCoarse;
    this.#mean_ms = (SLOW_MS + QUICK_MS) / 2;
    this.#quick_ms = 0;
  }
}
