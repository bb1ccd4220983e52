/**
 * Plays one clip after another on a rig, in time with recordings, with an idle clip between them.
 *
 * Whoever draws calls `update()` before each frame. What a clip is played by is asked of a clock: the time of the
 * recording in seconds (`audio.currentTime`), so that lips never drift from the voice, whatever the frame rate is.
 */

import type { Clip, ClipEvent, Pose } from "../motion/clip.js";
import { blended, sampled } from "../motion/sampling.js";

/** Anything that wears poses: a Retargeting. */
export interface PoseTarget {
  show(pose: Pose): void;
}

/** Tells a time in seconds. */
export type Clock = () => number;

/** How a clip is played. */
export interface PlayOptions {
  /** The time of the recording; the time since `play` unless given. */
  readonly clock?: Clock;
  /** Seconds from what is shown now to the clip; .25 unless given. */
  readonly fadeS?: number;
  /** Called at each sync point of a behaviour, as it is passed. */
  readonly onEvent?: (event: ClipEvent) => void;
  /** Called once, after the last frame. */
  readonly onEnd?: () => void;
}

interface Playing {
  readonly clip: Clip;
  readonly options: PlayOptions;
  readonly timeS: Clock;
  readonly startedS: number;
  readonly from: Pose | undefined;
  toldS: number;
}

const FADE_S = 0.25;

/** A figure that plays clips. */
export class Performer {
  readonly #target: PoseTarget;
  readonly #now: Clock;
  readonly #idle: Clip | undefined;
  #playing: Playing | undefined;
  #shown: Pose | undefined;

  /** `idle` is played to and fro while nothing else is. `now` is the time of the world, unless given the browser's. */
  constructor(target: PoseTarget, idle?: Clip, now: Clock = () => performance.now() / 1000) {
    this.#target = target;
    this.#idle = idle;
    this.#now = now;
  }

  /** Whether a clip other than the idle one is played. */
  get isPlaying(): boolean {
    return this.#playing !== undefined && this.#playing.clip !== this.#idle;
  }

  /** Plays a clip from now on, in place of what is played. */
  play(clip: Clip, options: PlayOptions = {}): void {
    const startedS = this.#now();
    const clock = options.clock ?? ((): number => this.#now() - startedS + clip.audioOffsetS);
    const timeS = (): number => clock() - clip.audioOffsetS;
    this.#playing = { clip, options, timeS, startedS, from: this.#shown, toldS: -Infinity };
  }

  /** Ends the clip that is played; the idle one follows. */
  stop(): void {
    this.#playing = undefined;
  }

  /** Shows the pose of this moment. */
  update(): void {
    if (!this.#playing && this.#idle) {
      this.#playIdle(this.#idle);
    }
    const playing = this.#playing;
    if (!playing) {
      return;
    }
    const timeS = playing.timeS();
    this.#show(playing, timeS);
    tellEvents(playing, timeS);
    if (timeS >= playing.clip.durationS && playing.clip !== this.#idle) {
      this.#playing = undefined;
      playing.options.onEnd?.();
    }
  }

  #show({ clip, options, startedS, from }: Playing, timeS: number): void {
    const fadeS = options.fadeS ?? FADE_S;
    const share = fadeS > 0 ? Math.min(1, (this.#now() - startedS) / fadeS) : 1;
    const pose = sampled(clip, timeS);
    this.#shown = from && share < 1 ? blended(from, pose, share * share * (3 - 2 * share)) : pose;
    this.#target.show(this.#shown);
  }

  #playIdle(idle: Clip): void {
    const startedS = this.#now();
    const clock = (): number => toAndFro(this.#now() - startedS, idle.durationS) + idle.audioOffsetS;
    this.play(idle, { clock, fadeS: 2 * FADE_S });
  }
}

/** Times that go from 0 to the end, back to 0, and so on. */
function toAndFro(timeS: number, durationS: number): number {
  const within = durationS > 0 ? timeS % (2 * durationS) : 0;
  return within < durationS ? within : 2 * durationS - within;
}

function tellEvents(playing: Playing, timeS: number): void {
  const { clip, options, toldS } = playing;
  playing.toldS = Math.max(toldS, timeS);
  for (const event of options.onEvent ? clip.events : []) {
    if (event.timeS > toldS && event.timeS <= timeS) {
      options.onEvent?.(event);
    }
  }
}
