/** Which of a pose's weights a face shows. */

import type { Pose } from "../motion/clip.js";

const VISEME = "viseme_";
const MOUTH = /^(jaw|mouth|tongue)/;

/** What is chosen for a face once. */
export interface FaceChoice {
  /** Whether `eyeLook…` shapes are shown: not where bones turn the eyes, for both together turn them twice. */
  readonly eyeLook: boolean;
}

/**
 * The weights by the names of the face's own shapes. A face without ARKit's `jawOpen` gets visemes (`viseme_aa`, or
 * `aa` alone) for the mouth.
 */
export function shownWeights(pose: Pose, shapes: ReadonlySet<string>, { eyeLook }: FaceChoice): Map<string, number> {
  const speaksByVisemes = !shapes.has("jawOpen") && pose.visemes.size > 0;
  const isShown = (name: string): boolean =>
    !(speaksByVisemes && MOUTH.test(name)) && (eyeLook || !name.startsWith("eyeLook"));
  const wanted = [
    ...Array.from(pose.shapes).filter(([name]) => isShown(name)),
    ...(speaksByVisemes ? visemeWeights(pose, shapes) : []),
  ];
  return new Map(wanted.filter(([name]) => shapes.has(name)));
}

function visemeWeights(pose: Pose, shapes: ReadonlySet<string>): [string, number][] {
  return Array.from(pose.visemes, ([name, weight]) => [shapes.has(VISEME + name) ? VISEME + name : name, weight]);
}
