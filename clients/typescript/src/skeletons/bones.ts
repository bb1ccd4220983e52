/** Which bone of a rig is which joint of a clip. */

import { RIGS } from "./rigs.js";

/** Bones' names by the names of the clip's joints (VRM's). Joints that are not in it are not played. */
export type BoneMap = Readonly<Record<string, string>>;

/** Joints without which a body cannot be played. */
const NEEDED = ["hips", "spine", "head", "leftUpperArm", "leftLowerArm", "rightUpperArm", "rightLowerArm"];

/** The tables of the service by name: mixamo, ready_player_me, unreal, vrm … */
export const BONE_MAPS: Readonly<Record<string, BoneMap>> = RIGS;

/**
 * The table that knows most of these bones. Names are compared without what loaders take out of them: three.js
 * loads `mixamorig:Hips` as `mixamorigHips`. Throws a RangeError where none has all joints that are needed.
 */
export function foundBones(bones: Iterable<string>): BoneMap {
  const byPlainName = new Map(Array.from(bones, (name) => [plain(name), name]));
  const found = Object.values(BONE_MAPS)
    .map((table) => present(table, byPlainName))
    .filter((table) => NEEDED.every((joint) => joint in table))
    .sort((a, b) => Object.keys(b).length - Object.keys(a).length);
  const [best] = found;
  if (!best) {
    const known = Object.keys(BONE_MAPS).join(", ");
    throw new RangeError(`no table has the names of these bones (${known}); give a BoneMap`);
  }
  return best;
}

function present(table: BoneMap, byPlainName: ReadonlyMap<string, string>): BoneMap {
  const pairs = Object.entries(table).map(([joint, name]) => [joint, byPlainName.get(plain(name))] as const);
  return Object.fromEntries(pairs.filter((pair): pair is [string, string] => pair[1] !== undefined));
}

function plain(name: string): string {
  return name.replace(/[\s[\].:/_]/g, "");
}
