/**
 * What a clip is played on: the nodes of any engine's skeleton as they rest, and how they and blend shapes are set.
 *
 * The rest pose may be a T-pose or an A-pose, in any unit; Y is up, and the figure faces +Z or -Z.
 */

import type { Quaternion, Vector } from "../motion/vectors.js";

/** A node of the skeleton at rest, in its parent. Parents come before their children; -1 is none. */
export interface RestNode {
  readonly name: string;
  readonly parent: number;
  readonly place: Vector;
  readonly turn: Quaternion;
  /** The same along all axes. */
  readonly scale: number;
}

/** A skeleton with a face. Nodes go by their number in `nodes`. */
export interface Rig {
  readonly nodes: readonly RestNode[];
  /** The names of its blend shapes. */
  readonly shapes: ReadonlySet<string>;
  setTurn(node: number, turn: Quaternion): void;
  setPlace(node: number, place: Vector): void;
  setWeight(shape: string, weight: number): void;
}

/** A node at rest in the space of the whole rig. */
export interface RestInRig {
  readonly place: Vector;
  readonly turn: Quaternion;
  readonly scale: number;
}
