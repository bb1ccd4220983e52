/** Poses on rigs of other shapes, made by hand: where limbs point must be as in the clip. */

import assert from "node:assert/strict";
import { test } from "node:test";

import { sampled } from "../../src/motion/sampling.js";
import { add, multiply, NO_TURN, rotate, scaled, type Quaternion, type Vector } from "../../src/motion/vectors.js";
import { Retargeting } from "../../src/skeletons/retargeting.js";
import type { RestNode, Rig } from "../../src/skeletons/rig.js";
import { clip, JOINTS, QUARTER_ABOUT_Z, track } from "../support/clips.js";
import { assertNear } from "../support/near.js";

const BONES = Object.fromEntries(JOINTS.map(({ name }) => [name, name]));
const EIGHTH_DOWN: Quaternion = [0, 0, -Math.sin(Math.PI / 8), Math.cos(Math.PI / 8)];

/** A rig that remembers how it was set. */
class RememberingRig implements Rig {
  readonly weights = new Map<string, number>();
  readonly #now: { place: Vector; turn: Quaternion }[];

  constructor(
    readonly nodes: readonly RestNode[],
    readonly shapes: ReadonlySet<string> = new Set(),
  ) {
    this.#now = nodes.map(({ place, turn }) => ({ place, turn }));
  }

  setTurn(node: number, turn: Quaternion): void {
    this.#now[node] = { place: this.#now[node]?.place ?? [0, 0, 0], turn };
  }

  setPlace(node: number, place: Vector): void {
    this.#now[node] = { place, turn: this.#now[node]?.turn ?? NO_TURN };
  }

  setWeight(shape: string, weight: number): void {
    this.weights.set(shape, weight);
  }

  /** Where a node is now in the rig's space. */
  place(name: string): Vector {
    return this.#frame(this.nodes.findIndex((node) => node.name === name)).place;
  }

  #frame(number: number): { place: Vector; turn: Quaternion; scale: number } {
    const node = this.nodes[number];
    const now = this.#now[number];
    if (!node || !now) {
      return { place: [0, 0, 0], turn: NO_TURN, scale: 1 };
    }
    const above = this.#frame(node.parent);
    return {
      place: add(above.place, rotate(above.turn, scaled(now.place, above.scale))),
      turn: multiply(above.turn, now.turn),
      scale: above.scale * node.scale,
    };
  }
}

/** The clip's own body as a rig. `turns` are rests of some joints. */
function body(turns: Readonly<Record<string, Quaternion>> = {}, left = 1): RestNode[] {
  return JOINTS.map(({ name, parent, offsetM: [x, y, z] }) => ({
    name,
    parent: JOINTS.findIndex((joint) => joint.name === parent),
    place: [x * left, y, z],
    turn: turns[name] ?? NO_TURN,
    scale: 1,
  }));
}

const LEFT_ARM_UP = sampled(clip({ turns: new Map([["leftUpperArm", track(4, [...QUARTER_ABOUT_Z])]]) }), 0);

test("on a rig like the clip's an arm that is turned up points up", () => {
  const rig = new RememberingRig(body());
  new Retargeting(rig, JOINTS, { bones: BONES }).show(LEFT_ARM_UP);
  assertNear(rig.place("leftLowerArm"), [0.2, 1.8, 0]);
  assertNear(rig.place("rightHand"), [-0.75, 1.5, 0]);
});

test("a rig that rests in an A-pose shows the same pose", () => {
  const rig = new RememberingRig(body({ leftUpperArm: EIGHTH_DOWN }));
  const retargeting = new Retargeting(rig, JOINTS, { bones: BONES });
  retargeting.show(LEFT_ARM_UP);
  assertNear(rig.place("leftHand"), [0.2, 2.05, 0]);
  retargeting.show(sampled(clip(), 0));
  assertNear(rig.place("leftHand"), [0.75, 1.5, 0]);
});

test("joints that the rig lacks are passed on to those below", () => {
  const rig = new RememberingRig(body());
  const bones = Object.fromEntries(Object.entries(BONES).filter(([joint]) => joint !== "spine"));
  const leaning = sampled(clip({ turns: new Map([["spine", track(4, [...QUARTER_ABOUT_Z])]]) }), 0);
  new Retargeting(rig, JOINTS, { bones }).show(leaning);
  assertNear(rig.place("leftUpperArm"), [0.2, 1.5, 0]);
  assertNear(rig.place("leftLowerArm"), [0.2, 1.8, 0]);
});

test("a rig that faces backwards, as VRM 0 does, raises the same arm", () => {
  const rig = new RememberingRig(body({}, -1));
  new Retargeting(rig, JOINTS, { bones: BONES }).show({ ...LEFT_ARM_UP, hipsM: [0.1, 1, 0.2] });
  assertNear(rig.place("leftLowerArm"), [-0.3, 1.8, -0.2]);
});

test("hips move as far as the legs are long, whatever the unit above them is", () => {
  const inCentimetres = body().map((node) => ({ ...node, parent: node.parent + 1, place: scaled(node.place, 200) }));
  const rig = new RememberingRig([{ name: "Armature", parent: -1, place: [0, 0, 0], turn: NO_TURN, scale: 0.01 }, ...inCentimetres]);
  new Retargeting(rig, JOINTS, { bones: BONES }).show(sampled(clip({ hips: track(3, [0.1, 0.9, 0]) }), 0));
  assertNear(rig.place("hips"), [0.2, 1.8, 0]);
});

test("a rig without hips, or whose children come first, is refused", () => {
  assert.throws(() => new Retargeting(new RememberingRig(body()), JOINTS, { bones: { head: "head" } }), /hips/);
  const [hips, spine] = body();
  assert.ok(hips && spine);
  const wrong = new RememberingRig([{ ...spine, parent: 1 }, { ...hips, parent: -1 }]);
  assert.throws(() => new Retargeting(wrong, JOINTS, { bones: BONES }), /comes before its parent/);
});

test("blend shapes that the face has are set", () => {
  const rig = new RememberingRig(body(), new Set(["jawOpen"]));
  const pose = sampled(clip({ shapes: new Map([["jawOpen", track(1, [0.4])], ["mouthClose", track(1, [1])]]) }), 0);
  new Retargeting(rig, JOINTS, { bones: BONES }).show(pose);
  assertNear(Array.from(rig.weights.values()), [0.4], 1e-6);
});
