/**
 * A clip: how a body and a face move, whichever file it came in.
 *
 * Conventions are the service's (docs/motion-formats.md): metres, Y up, facing +Z, seconds from the first frame, turns
 * local to the parent, no turn in the T-pose. Joints have VRM's names.
 */

import type { Quaternion, Vector } from "./vectors.js";

/** Keys of `size` numbers each, one for each of `timesS`; a track that does not change has one. */
export interface Track {
  readonly timesS: Float32Array;
  readonly values: Float32Array;
  readonly size: number;
}

/** A joint in the T-pose; `offsetM` is its place in its parent, that of the hips in the world. */
export interface Joint {
  readonly name: string;
  readonly parent: string | null;
  readonly offsetM: Vector;
}

/** When a behaviour of the BML reaches a sync point. */
export interface ClipEvent {
  readonly behavior: string;
  readonly point: string;
  readonly timeS: number;
}

export interface Clip {
  readonly durationS: number;
  /** When the first frame is, in seconds of the recording; negative with a lead-in. */
  readonly audioOffsetS: number;
  readonly joints: readonly Joint[];
  /** Where the hips are. */
  readonly hips: Track;
  readonly turns: ReadonlyMap<string, Track>;
  /** Weights of ARKit's blend shapes by name. */
  readonly shapes: ReadonlyMap<string, Track>;
  /** Weights of the fifteen visemes, for faces that have these in place of ARKit's mouth; empty without speech. */
  readonly visemes: ReadonlyMap<string, Track>;
  readonly events: readonly ClipEvent[];
}

/** A body and a face at one time. */
export interface Pose {
  readonly hipsM: Vector;
  readonly turns: ReadonlyMap<string, Quaternion>;
  readonly shapes: ReadonlyMap<string, number>;
  readonly visemes: ReadonlyMap<string, number>;
}
