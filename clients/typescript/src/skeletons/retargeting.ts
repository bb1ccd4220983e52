/**
 * Poses of clips on a rig, whatever its rest pose, unit and bones' axes.
 *
 * A bone is turned in the rig's space as the joint is in the clip's, from the T-pose. Nodes that no joint is mapped to
 * rest in their parents; joints that no bone is mapped to are passed on to those below. The hips move as far as the
 * rig's legs are long.
 */

import type { Joint, Pose } from "../motion/clip.js";
import { add, inverse, multiply, NO_TURN, rotate, scaled, subtract } from "../motion/vectors.js";
import type { Quaternion, Vector } from "../motion/vectors.js";
import { frontOf, turnsToTPose } from "./alignment.js";
import { foundBones, type BoneMap } from "./bones.js";
import { shownWeights, type FaceChoice } from "./faces.js";
import { ORIGIN, restsInRig } from "./rest.js";
import type { RestInRig, RestNode, Rig } from "./rig.js";

const HIPS = "hips";

/** What may be said of a rig. */
export interface RetargetOptions extends Partial<FaceChoice> {
  /** Found by the names of the bones unless given. */
  readonly bones?: BoneMap;
}

/** A node that is turned as a joint is. */
interface Bone {
  readonly node: number;
  readonly joint: string;
  /** The rest of its direct parent. */
  readonly parent: RestInRig;
  /** The joint of the nearest bone above it. */
  readonly above: string | undefined;
  /** Its turn in the rig's space in the T-pose. */
  readonly tPose: Quaternion;
}

/** A rig that wears poses. Make it once, while the rig rests. */
export class Retargeting {
  readonly #rig: Rig;
  readonly #joints: readonly Joint[];
  readonly #bones: readonly Bone[];
  readonly #front: Quaternion;
  readonly #toTPose: ReadonlyMap<string, Quaternion>;
  readonly #hips: RestInRig;
  readonly #face: FaceChoice;

  /** `joints` are those of the clips. Throws a RangeError where bones are not found. */
  constructor(rig: Rig, joints: readonly Joint[], options: RetargetOptions = {}) {
    const bones = options.bones ?? foundBones(rig.nodes.map(({ name }) => name));
    const mapped = mappedNodes(rig, bones);
    const rests = restsInRig(rig.nodes);
    const places = new Map(Array.from(mapped, ([node, joint]) => [joint, (rests[node] ?? ORIGIN).place]));
    this.#rig = rig;
    this.#joints = joints;
    this.#front = frontOf(places);
    this.#toTPose = turnsToTPose(joints, places, this.#front);
    this.#bones = Array.from(mapped, ([node, joint]) => {
      const { parent, turn } = restOf(rests, rig.nodes, node);
      const tPose = multiply(this.#toTPose.get(joint) ?? NO_TURN, turn);
      return { node, joint, parent, above: jointAbove(rig.nodes, mapped, node), tPose };
    });
    this.#hips = rests[this.#bones.find(({ joint }) => joint === HIPS)?.node ?? -1] ?? ORIGIN;
    this.#face = { eyeLook: options.eyeLook ?? !places.has("leftEye") };
  }

  /** Sets bones and blend shapes as in the pose. */
  show(pose: Pose): void {
    const turned = this.#turned(pose);
    for (const { node, joint, parent, above, tPose } of this.#bones) {
      const now = multiply(turned.get(joint) ?? NO_TURN, tPose);
      const moved = above === undefined ? NO_TURN : this.#fromRest(above, turned);
      this.#rig.setTurn(node, multiply(inverse(multiply(moved, parent.turn)), now));
      if (joint === HIPS) {
        this.#rig.setPlace(node, this.#hipsPlace(pose.hipsM, parent));
      }
    }
    for (const [shape, weight] of shownWeights(pose, this.#rig.shapes, this.#face)) {
      this.#rig.setWeight(shape, weight);
    }
  }

  /** How far each joint is turned from the T-pose in the rig's space. */
  #turned(pose: Pose): ReadonlyMap<string, Quaternion> {
    const inClip = new Map<string, Quaternion>();
    const inRig = new Map<string, Quaternion>();
    for (const { name, parent } of this.#joints) {
      const above = (parent === null ? undefined : inClip.get(parent)) ?? NO_TURN;
      const turn = multiply(above, pose.turns.get(name) ?? NO_TURN);
      inClip.set(name, turn);
      inRig.set(name, multiply(multiply(this.#front, turn), inverse(this.#front)));
    }
    return inRig;
  }

  /** How far a bone is turned from its rest in the rig's space. */
  #fromRest(joint: string, turned: ReadonlyMap<string, Quaternion>): Quaternion {
    return multiply(turned.get(joint) ?? NO_TURN, this.#toTPose.get(joint) ?? NO_TURN);
  }

  #hipsPlace(hipsM: Vector, parent: RestInRig): Vector {
    const restM = this.#joints.find(({ name }) => name === HIPS)?.offsetM ?? [0, 1, 0];
    const moved = rotate(this.#front, scaled(subtract(hipsM, restM), this.#hips.place[1] / restM[1]));
    const inParent = rotate(inverse(parent.turn), subtract(add(this.#hips.place, moved), parent.place));
    return scaled(inParent, 1 / parent.scale);
  }
}

/** A node's own turn and its parent's rest. */
function restOf(rests: readonly RestInRig[], nodes: readonly RestNode[], node: number): { parent: RestInRig; turn: Quaternion } {
  return { parent: rests[nodes[node]?.parent ?? -1] ?? ORIGIN, turn: rests[node]?.turn ?? NO_TURN };
}

/** The joint of the nearest node above that has one. */
function jointAbove(nodes: readonly RestNode[], mapped: ReadonlyMap<number, string>, node: number): string | undefined {
  let above = nodes[node]?.parent ?? -1;
  while (above >= 0 && !mapped.has(above)) {
    above = nodes[above]?.parent ?? -1;
  }
  return mapped.get(above);
}

/** The joint of each node that has one, parents first. */
function mappedNodes(rig: Rig, bones: BoneMap): ReadonlyMap<number, string> {
  const joints = new Map(Object.entries(bones).map(([joint, bone]) => [bone, joint]));
  const mapped = new Map<number, string>();
  for (const [number, { name }] of rig.nodes.entries()) {
    const joint = joints.get(name);
    if (joint !== undefined) {
      mapped.set(number, joint);
    }
  }
  if (!Array.from(mapped.values()).includes(HIPS)) {
    throw new RangeError("the rig has no bone for the hips");
  }
  return mapped;
}
