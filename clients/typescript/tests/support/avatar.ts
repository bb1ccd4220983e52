/** An avatar that is as unlike the service's own body as files of others are: a rig's names, centimetres under a scaled
 * node, an A-pose, and bones whose axes point anywhere. */

import type { Joint } from "../../src/motion/clip.js";
import { add, inverse, multiply, NO_TURN, normalized, rotate, scaled, subtract } from "../../src/motion/vectors.js";
import type { Quaternion, Vector } from "../../src/motion/vectors.js";
import { BONE_MAPS } from "../../src/skeletons/bones.js";

const CENTIMETRES = 100;
const DROP_RAD = 0.7;
const BUFFER_BYTES = 4;

/** Its GLB, which has nodes and nothing else. */
export function avatarGlb(joints: readonly Joint[], rig: string): ArrayBuffer {
  const names = BONE_MAPS[rig] ?? {};
  const places = aPose(joints);
  const turns = new Map(joints.map(({ name }, number) => [name, anyTurn(number)]));
  const nodes = joints.map(({ name, parent }) => {
    const above = (parent === null ? undefined : turns.get(parent)) ?? NO_TURN;
    const offset = subtract(places.get(name) ?? [0, 0, 0], (parent === null ? undefined : places.get(parent)) ?? [0, 0, 0]);
    return {
      name: names[name] ?? name,
      translation: rotate(inverse(above), scaled(offset, CENTIMETRES)),
      rotation: multiply(inverse(above), turns.get(name) ?? NO_TURN),
      ...childrenOf(joints, name),
    };
  });
  const armature = { name: "Armature", scale: [1, 1, 1].map((one) => one / CENTIMETRES), children: [0] };
  const scenes = [{ nodes: [joints.length] }];
  const buffers = [{ byteLength: BUFFER_BYTES }];
  return glb({ asset: { version: "2.0" }, scene: 0, scenes, nodes: [...nodes, armature], buffers });
}

/** Where the joints are with both arms hanging down by `DROP_RAD`. */
function aPose(joints: readonly Joint[]): ReadonlyMap<string, Vector> {
  const places = new Map<string, Vector>();
  const dropped = new Map<string, Quaternion>();
  for (const { name, parent, offsetM } of joints) {
    const turn = (parent === null ? undefined : dropped.get(parent)) ?? NO_TURN;
    places.set(name, add((parent === null ? undefined : places.get(parent)) ?? [0, 0, 0], rotate(turn, offsetM)));
    const drop = name === "leftUpperArm" ? -DROP_RAD : name === "rightUpperArm" ? DROP_RAD : 0;
    dropped.set(name, multiply(turn, [0, 0, Math.sin(drop / 2), Math.cos(drop / 2)]));
  }
  return places;
}

function anyTurn(number: number): Quaternion {
  return normalized([Math.sin(number), Math.cos(3 * number), Math.sin(5 * number + 1), Math.cos(7 * number)]);
}

function childrenOf(joints: readonly Joint[], name: string): { children?: number[] } {
  const children = joints.flatMap((joint, number) => (joint.parent === name ? [number] : []));
  return children.length > 0 ? { children } : {};
}

function glb(tree: object): ArrayBuffer {
  const text = JSON.stringify(tree);
  const json = new TextEncoder().encode(text + " ".repeat(-text.length & 3));
  const file = new Uint8Array(20 + json.length + 8 + BUFFER_BYTES);
  const view = new DataView(file.buffer);
  [0x46546c67, 2, file.length, json.length, 0x4e4f534a].forEach((number, index) => {
    view.setUint32(4 * index, number, true);
  });
  file.set(json, 20);
  view.setUint32(20 + json.length, BUFFER_BYTES, true);
  view.setUint32(24 + json.length, 0x004e4942, true);
  return file.buffer;
}
