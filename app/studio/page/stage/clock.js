/**
 * Tells where the performance is while it is played. The recording leads: what is shown is the pose of the time that the
 * audio has reached, whatever the frame rate is. Before the recording begins (a lead-in), backwards, and where there is no
 * recording, the time runs by itself.
 */

import { PERFORMED, PLAYBACK, TIME_S } from "../state/performed.js";

/** @import { Store } from "../state/store.js" */

const NEAR_END_S = 0.005;

/** Keeps an audio element and TIME_S together. */
export class Clock {
  #store;
  #audio;
  #told_s = 0;
  #last_ms = 0;

  /**
   * @param {Store} store
   * @param {HTMLAudioElement} audio the recording
   */
  constructor(store, audio) {
    this.#store = store;
    this.#audio = audio;
    store.watch(PLAYBACK, ({ playing, speed }) => {
      audio.playbackRate = Math.abs(speed);
      if (playing) {
        this.#start();
      } else {
        audio.pause();
      }
    });
    store.watch(TIME_S, (time_s) => {
      if (time_s !== this.#told_s) {
        this.#seek(time_s);
      }
    });
  }

  /** The length of the performance, seconds. */
  get end_s() {
    const line = this.#store.get(PERFORMED);
    return line ? line.performance.lead_in_s + line.performance.audio.duration_s : 0;
  }

  /**
   * Moves TIME_S on to this moment; call it before each frame.
   *
   * @param {number} now_ms
   */
  update(now_ms) {
    const { playing, speed, loop } = this.#store.get(PLAYBACK);
    const passed_s = ((now_ms - this.#last_ms) / 1000) * speed;
    this.#last_ms = now_ms;
    if (!playing) {
      return;
    }
    if (speed < 0) {
      this.#back(passed_s);
      return;
    }
    const [start_s, end_s] = loop ?? [0, this.end_s];
    const time_s = this.#reached(passed_s);
    if (time_s < end_s - NEAR_END_S) {
      this.#tell(time_s);
    } else if (loop) {
      this.#tell(start_s);
      this.#seek(start_s);
    } else {
      this.#tell(end_s);
      this.#store.patch(PLAYBACK, { playing: false });
    }
  }

  /** @param {number} passed_s below 0 */
  #back(passed_s) {
    this.#audio.pause();
    const time_s = Math.max(0, this.#told_s + passed_s);
    this.#tell(time_s);
    if (time_s === 0) {
      this.#store.patch(PLAYBACK, { playing: false, speed: 1 });
    }
  }

  get #lead_in_s() {
    return this.#store.get(PERFORMED)?.performance.lead_in_s ?? 0;
  }

  /** @param {number} passed_s since the last frame */
  #reached(passed_s) {
    const audio = this.#audio;
    if (audio.ended) {
      return this.end_s;
    }
    if (this.#isSilent) {
      return this.#told_s + passed_s;
    }
    if (this.#told_s < this.#lead_in_s) {
      const time_s = Math.min(this.#told_s + passed_s, this.#lead_in_s);
      if (time_s === this.#lead_in_s) {
        this.#sound();
      }
      return time_s;
    }
    return audio.currentTime + this.#lead_in_s;
  }

  #start() {
    const loop = this.#store.get(PLAYBACK).loop;
    const isOver = this.#told_s >= this.end_s - NEAR_END_S;
    const isOutside = loop && (this.#told_s < loop[0] || this.#told_s >= loop[1]);
    if (isOver || isOutside) {
      this.#tell(loop?.[0] ?? 0);
    }
    this.#seek(this.#told_s);
  }

  /** @param {number} time_s */
  #seek(time_s) {
    this.#told_s = time_s;
    this.#audio.currentTime = Math.max(0, time_s - this.#lead_in_s);
    const { playing, speed } = this.#store.get(PLAYBACK);
    if (playing && speed > 0 && time_s >= this.#lead_in_s) {
      this.#sound();
    } else {
      this.#audio.pause();
    }
  }

  /** Whether there is nothing to hear. */
  get #isSilent() {
    return !this.#audio.hasAttribute("src");
  }

  #sound() {
    if (this.#isSilent) {
      return;
    }
    this.#audio.play().catch(() => this.#store.patch(PLAYBACK, { playing: false }));
  }

  /** @param {number} time_s */
  #tell(time_s) {
    this.#told_s = time_s;
    this.#store.set(TIME_S, time_s);
  }
}
