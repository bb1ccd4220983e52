/** Reads a clip from the service's JSON (docs/motion-formats.md, "Clip JSON"). */

import type { ClipJson } from "../service/types.js";
import type { Clip, Joint, Track } from "./clip.js";

const VERSION = 1;

/** The clip. Throws a RangeError for a version that is not known here, or a skeleton with other names than VRM's. */
export function clipFromJson(answer: ClipJson): Clip {
  if (answer.version !== VERSION) {
    throw new RangeError(`this client reads version ${VERSION} of clips, and this is version ${answer.version}`);
  }
  if (answer.skeleton.name !== "vrm") {
    throw new RangeError(`joints have the names of ${answer.skeleton.name}; realize without the option skeleton`);
  }
  const timesS = Float32Array.from({ length: answer.frames }, (_, frame) => frame / answer.frame_rate_hz);
  const weights = (tracks: Record<string, number[]>): Map<string, Track> =>
    new Map(Object.entries(tracks).map(([name, values]) => [name, track(values, 1, timesS)]));
  return {
    durationS: answer.duration_s,
    audioOffsetS: answer.audio_offset_s,
    joints: answer.skeleton.joints.map(joint),
    hips: track(answer.hips_m.flat(), 3, timesS),
    turns: new Map(Object.entries(answer.bones).map(([name, values]) => [name, track(values.flat(), 4, timesS)])),
    shapes: weights(answer.blendshapes),
    visemes: weights(answer.visemes ?? {}),
    events: answer.events.map(({ behavior, point, time_s }) => ({ behavior, point, timeS: time_s })),
  };
}

function joint({ name, parent, offset_m: [x = 0, y = 0, z = 0] }: ClipJson["skeleton"]["joints"][number]): Joint {
  return { name, parent, offsetM: [x, y, z] };
}

function track(values: readonly number[], size: number, timesS: Float32Array): Track {
  return { timesS: timesS.subarray(0, values.length / size), values: Float32Array.from(values), size };
}
