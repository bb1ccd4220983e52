/** Clips made by hand: a body of eleven joints in a T-pose, whose turns a test chooses. */

import type { Clip, Joint, Track } from "../../src/motion/clip.js";
import type { Quaternion } from "../../src/motion/vectors.js";

export const HALF = Math.SQRT1_2;

/** A quarter turn about Z, which takes an arm that points to +X up. */
export const QUARTER_ABOUT_Z: Quaternion = [0, 0, HALF, HALF];

export const JOINTS: readonly Joint[] = [
  { name: "hips", parent: null, offsetM: [0, 1, 0] },
  { name: "spine", parent: "hips", offsetM: [0, 0.2, 0] },
  { name: "head", parent: "spine", offsetM: [0, 0.4, 0] },
  ...(["left", "right"] as const).flatMap((side) => {
    const away = side === "left" ? 1 : -1;
    return [
      { name: `${side}UpperArm`, parent: "spine", offsetM: [0.2 * away, 0.3, 0] },
      { name: `${side}LowerArm`, parent: `${side}UpperArm`, offsetM: [0.3 * away, 0, 0] },
      { name: `${side}Hand`, parent: `${side}LowerArm`, offsetM: [0.25 * away, 0, 0] },
    ] satisfies Joint[];
  }),
];

export function track(size: number, ...keys: readonly (readonly number[])[]): Track {
  return { timesS: Float32Array.from(keys.keys()), values: Float32Array.from(keys.flat()), size };
}

/** A clip with a key a second. */
export function clip(parts: Partial<Clip> = {}): Clip {
  return {
    durationS: 2,
    audioOffsetS: 0,
    joints: JOINTS,
    hips: track(3, [0, 1, 0]),
    turns: new Map(),
    shapes: new Map(),
    visemes: new Map(),
    events: [],
    ...parts,
  };
}
