/**
 * Rigs of three.js, by what its objects have; three itself is not imported.
 *
 * Blend shapes are the morph targets of every mesh below the root, by their names without a prefix as `face.`.
 */

import type { Quaternion, Vector } from "../motion/vectors.js";
import type { RestNode, Rig } from "./rig.js";

interface ThreeTuple {
  readonly x: number;
  readonly y: number;
  readonly z: number;
  set(x: number, y: number, z: number, w?: number): unknown;
}

/** What is asked of an Object3D; a Mesh has morph targets besides. */
export interface ThreeObject {
  readonly name: string;
  readonly children: readonly ThreeObject[];
  readonly position: ThreeTuple;
  readonly quaternion: ThreeTuple & { readonly w: number; set(x: number, y: number, z: number, w: number): unknown };
  readonly scale: ThreeTuple;
  readonly morphTargetDictionary?: Readonly<Record<string, number>> | undefined;
  readonly morphTargetInfluences?: number[] | undefined;
}

/** The rig below `root`, which may itself stand anywhere. Make it while the figure rests. */
export function rigFromThree(root: ThreeObject): Rig {
  const placed: Placed[] = [];
  addBelow(root, -1, placed);
  const targets = morphTargets(placed.map(({ object }) => object));
  return {
    nodes: placed.map(rest),
    shapes: new Set(targets.keys()),
    setTurn: (node, turn) => placed[node]?.object.quaternion.set(...turn),
    setPlace: (node, place) => placed[node]?.object.position.set(...place),
    setWeight: (shape, weight) => {
      for (const { influences, index } of targets.get(shape) ?? []) {
        influences[index] = weight;
      }
    },
  };
}

interface Placed {
  readonly object: ThreeObject;
  readonly parent: number;
}

interface Target {
  readonly influences: number[];
  readonly index: number;
}

function addBelow(parent: ThreeObject, number: number, placed: Placed[]): void {
  for (const object of parent.children) {
    const own = placed.push({ object, parent: number }) - 1;
    addBelow(object, own, placed);
  }
}

function rest({ object, parent }: Placed): RestNode {
  const { position, quaternion, scale } = object;
  const place: Vector = [position.x, position.y, position.z];
  const turn: Quaternion = [quaternion.x, quaternion.y, quaternion.z, quaternion.w];
  return { name: object.name, parent, place, turn, scale: Math.cbrt(scale.x * scale.y * scale.z) };
}

function morphTargets(objects: readonly ThreeObject[]): ReadonlyMap<string, readonly Target[]> {
  const targets = new Map<string, Target[]>();
  for (const { morphTargetDictionary, morphTargetInfluences } of objects) {
    for (const [name, index] of morphTargetInfluences ? Object.entries(morphTargetDictionary ?? {}) : []) {
      const shape = name.slice(name.lastIndexOf(".") + 1);
      targets.set(shape, [...(targets.get(shape) ?? []), { influences: morphTargetInfluences ?? [], index }]);
    }
  }
  return targets;
}
