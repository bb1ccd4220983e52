/** The scene's time: recordings lead while lines are spoken, pauses between them run by themselves. */

import { lineAt } from "./sequence.js";

/** @import { Span } from "./sequence.js" */

export class SceneClock {
  #audio;
  #spans;
  #sounds;
  #line = -1;
  #last_ms = 0;
  time_s = 0;
  playing = false;

  /**
   * @param {HTMLAudioElement} audio
   * @param {readonly Span[]} spans
   * @param {readonly string[]} sounds the addresses of the recordings
   */
  constructor(audio, spans, sounds) {
    this.#audio = audio;
    this.#spans = spans;
    this.#sounds = sounds;
  }

  get end_s() {
    return this.#spans.at(-1)?.end_s ?? 0;
  }

  /** The place of the line that is spoken, or was the last. */
  get line() {
    return lineAt(this.#spans, this.time_s);
  }

  /** Plays or pauses; at the end, plays again from the start. */
  toggle() {
    this.playing = !this.playing;
    if (this.playing && this.time_s >= this.end_s) {
      this.time_s = 0;
    }
    this.seek(this.time_s);
  }

  /** @param {number} time_s */
  playFrom(time_s) {
    this.seek(time_s);
    this.playing = true;
  }

  pause() {
    if (this.playing) {
      this.toggle();
    }
  }

  /** @param {number} time_s */
  seek(time_s) {
    this.time_s = Math.min(this.end_s, Math.max(0, time_s));
    this.#audio.pause();
    this.#line = -1;
  }

  /**
   * Moves on to this moment; call it before each frame.
   *
   * @param {number} now_ms
   */
  update(now_ms) {
    const passed_s = (now_ms - this.#last_ms) / 1000;
    this.#last_ms = now_ms;
    if (!this.playing) {
      return;
    }
    const span = this.#spans[this.line];
    const isSpoken = span !== undefined && this.time_s < span.end_s;
    if (isSpoken) {
      this.#sound(span);
    }
    const isHeard = isSpoken && !this.#audio.ended;
    this.time_s = isHeard ? Math.max(this.time_s, span.start_s + this.#audio.currentTime) : this.time_s + passed_s;
    if (this.time_s >= this.end_s) {
      this.time_s = this.end_s;
      this.playing = false;
    }
  }

  /**
   * Has the line's recording play, if it does not yet.
   *
   * @param {Span} span
   */
  #sound({ start_s }) {
    const place = this.line;
    if (place !== this.#line) {
      this.#line = place;
      this.#audio.src = this.#sounds[place] ?? "";
      this.#audio.currentTime = this.time_s - start_s;
      this.#audio.play().catch(() => (this.playing = false));
    }
  }
}
