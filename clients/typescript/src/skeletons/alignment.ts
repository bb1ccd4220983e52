/**
 * From a rig's rest pose to the T-pose of clips.
 *
 * Arms, legs and fingers that point elsewhere, as in an A-pose, are turned there by the smallest turn, with all below
 * them; the trunk, the feet and the thumbs stay, since there bones of other rigs lie differently in the same pose.
 */

import type { Joint } from "../motion/clip.js";
import { multiply, NO_TURN, rotate, shortestTurn, subtract, type Quaternion, type Vector } from "../motion/vectors.js";

const FINGERS = ["Index", "Middle", "Ring", "Little"];

/** Joints that are turned to point to the second as in the T-pose, without their side. */
const POINTED: readonly (readonly [string, string])[] = [
  ["UpperArm", "LowerArm"],
  ["LowerArm", "Hand"],
  ["Hand", "MiddleProximal"],
  ["UpperLeg", "LowerLeg"],
  ["LowerLeg", "Foot"],
  ...FINGERS.flatMap((finger) => [
    [`${finger}Proximal`, `${finger}Intermediate`] as const,
    [`${finger}Intermediate`, `${finger}Distal`] as const,
  ]),
];

const TARGETS: ReadonlyMap<string, string> = new Map(
  ["left", "right"].flatMap((side) => POINTED.map(([joint, target]) => [side + joint, side + target] as const)),
);

/** A half turn about Y where the rig faces -Z, as VRM 0 does: its left is at a smaller X than its right. */
export function frontOf(places: ReadonlyMap<string, Vector>): Quaternion {
  const left = places.get("leftUpperArm")?.[0] ?? 0;
  const right = places.get("rightUpperArm")?.[0] ?? 0;
  return left < right ? [0, 1, 0, 0] : NO_TURN;
}

/** The turn of each joint, in the rig's space, from its rest to the T-pose. `places` are the joints' at rest. */
export function turnsToTPose(
  joints: readonly Joint[],
  places: ReadonlyMap<string, Vector>,
  front: Quaternion,
): ReadonlyMap<string, Quaternion> {
  const offsets = new Map(joints.map(({ name, offsetM }) => [name, offsetM]));
  const turns = new Map<string, Quaternion>();
  for (const { name, parent } of joints) {
    const above = (parent === null ? undefined : turns.get(parent)) ?? NO_TURN;
    const target = TARGETS.get(name);
    const rest = direction(places, name, target);
    const wanted = target === undefined ? undefined : offsets.get(target);
    const own = rest && wanted ? shortestTurn(rotate(above, rest), rotate(front, wanted)) : NO_TURN;
    turns.set(name, multiply(own, above));
  }
  return turns;
}

function direction(places: ReadonlyMap<string, Vector>, from: string, to: string | undefined): Vector | undefined {
  const start = places.get(from);
  const end = to === undefined ? undefined : places.get(to);
  return start && end ? subtract(end, start) : undefined;
}
