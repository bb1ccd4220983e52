/** The messages of a live stream (docs/live.md). Times are seconds of the sound. */

import type { components } from "../service/schema.js";

type Schemas = components["schemas"];

/** How a stream begins: rate and channels of its sound, who performs, `frames` (30 or 60) for the body's joints. */
export type LiveStart = Omit<Schemas["StartMessage"], "type">;
/** What the character says: words with times where they are known, else `text`. */
export type LiveWords = Omit<Schemas["WordsMessage"], "type">;

/** The answer to the start; with frames the names of joints and shapes, in the order of a frame's numbers. */
export interface LiveReady {
  readonly type: "ready";
  readonly sample_rate_hz: number;
  readonly character: string;
  readonly frames?: 30 | 60;
  readonly joints?: readonly string[];
  readonly shapes?: readonly string[];
}

/** A movement that begins, or, `revised`, one whose times have changed. Times are seconds of the sound. */
export interface LiveBehavior {
  readonly type: "gesture" | "head" | "face" | "gaze" | "eyes" | "posture";
  readonly id: string;
  readonly start_s: number;
  readonly lexeme: string;
  readonly sync: Readonly<Record<string, number>>;
  readonly hand?: string;
  readonly amount?: number;
  readonly direction?: string;
  readonly target?: string;
  readonly repetitions?: number;
  readonly reason?: string;
  readonly rule?: string;
  readonly function?: string;
  readonly first?: number;
  readonly last?: number;
  readonly revised?: boolean;
  readonly heard_s: number;
}

/** The movement is not made, or no more. */
export interface LiveWithdrawal {
  readonly type: "withdrawn";
  readonly id: string;
  readonly heard_s: number;
}

/** The shape of the mouth from `start_s` on. */
export interface LiveMouth {
  readonly type: "mouth";
  readonly start_s: number;
  readonly viseme: string;
  readonly articulation: number;
  readonly opening: number;
  readonly heard_s: number;
}

/** With a motion model: a phrase of a kind of movement begins, announced and then decided. */
export interface LivePhrase {
  readonly type: "phrase";
  readonly kind: number;
  readonly start_s: number;
  readonly decided: boolean;
  readonly heard_s: number;
}

/** The body at a time: x y z w for each joint, the place of the hips, and the weights of the face's shapes. */
export interface LiveFrame {
  readonly type: "frame";
  readonly time_s: number;
  readonly rotations: readonly number[];
  readonly hips_m: readonly number[];
  readonly shapes: readonly number[];
}

/** So many frames were left out, for they were read too slowly. */
export interface LiveFramesSkipped {
  readonly type: "frames_skipped";
  readonly count: number;
}

/** Something that was sent could not be used, and the stream goes on. */
export interface LiveError {
  readonly type: "error";
  readonly code: string;
  readonly detail: string;
  readonly field?: string;
  readonly goes_on: boolean;
}

/** What a stream yields, until it is done. */
export type LiveMessage = LiveBehavior | LiveWithdrawal | LiveMouth | LivePhrase | LiveFrame | LiveFramesSkipped | LiveError;

/** All that a client sends besides sound and the start. */
export type LiveCommand =
  | Schemas["WordsMessage"]
  | Schemas["SilenceMessage"]
  | Schemas["ListenMessage"]
  | Schemas["CommandMessage"];

/** The last message. */
export interface LiveDone {
  readonly type: "done";
  readonly duration_s: number;
}

/** All that the service sends. */
export type LiveReceived = LiveMessage | LiveReady | LiveDone;
