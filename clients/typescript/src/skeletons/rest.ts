/** Where nodes rest in the space of the whole rig. */

import { add, multiply, NO_TURN, rotate, scaled } from "../motion/vectors.js";
import type { RestInRig, RestNode } from "./rig.js";

export const ORIGIN: RestInRig = { place: [0, 0, 0], turn: NO_TURN, scale: 1 };

/** Every node's rest. Throws a RangeError where a child comes before its parent. */
export function restsInRig(nodes: readonly RestNode[]): readonly RestInRig[] {
  const rests: RestInRig[] = [];
  for (const node of nodes) {
    const parent = node.parent < 0 ? ORIGIN : rests[node.parent];
    if (!parent) {
      throw new RangeError(`node ${node.name} comes before its parent`);
    }
    rests.push({
      place: add(parent.place, rotate(parent.turn, scaled(node.place, parent.scale))),
      turn: multiply(parent.turn, node.turn),
      scale: parent.scale * node.scale,
    });
  }
  return rests;
}
