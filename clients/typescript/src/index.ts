/**
 * Client of the Understudy service: performs lines, and plays their motion on any skeleton.
 *
 * Begin with `UnderstudyClient`; `clipFromJson`, `rigFromThree`, `Retargeting` and `Performer` play what it answers.
 */

export * from "./service/client.js";
export * from "./service/errors.js";
export { DEFAULT_POLICY, type RetryPolicy } from "./service/retrying.js";
export { performEach, type PerformedLine, type StreamOptions } from "./service/streaming.js";
export type * from "./service/types.js";
export type * from "./live/messages.js";
export { LiveStream, type LiveAddress } from "./live/stream.js";
export type * from "./motion/clip.js";
export type { Quaternion, Vector } from "./motion/vectors.js";
export { clipFromGlb } from "./motion/glb.js";
export { clipFromJson } from "./motion/clip_json.js";
export { blended, sampled } from "./motion/sampling.js";
export { BONE_MAPS, foundBones, type BoneMap } from "./skeletons/bones.js";
export type { RestNode, Rig } from "./skeletons/rig.js";
export { Retargeting, type RetargetOptions } from "./skeletons/retargeting.js";
export { rigFromThree, type ThreeObject } from "./skeletons/three.js";
export { Performer, type Clock, type PlayOptions, type PoseTarget } from "./playing/performer.js";
