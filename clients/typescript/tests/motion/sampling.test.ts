import assert from "node:assert/strict";
import { test } from "node:test";

import { blended, sampled } from "../../src/motion/sampling.js";
import { clip, QUARTER_ABOUT_Z, track } from "../support/clips.js";
import { assertNear } from "../support/near.js";

const MOVING = clip({
  hips: track(3, [0, 1, 0], [0, 1, 2], [0, 1, 2]),
  turns: new Map([["head", track(4, [0, 0, 0, 1], [...QUARTER_ABOUT_Z])]]),
  shapes: new Map([["jawOpen", track(1, [0], [1], [0.5])]]),
});

test("between keys everything is on the way, and at a key as it says", () => {
  const pose = sampled(MOVING, 0.5);
  assertNear(pose.hipsM, [0, 1, 1]);
  assertNear(pose.turns.get("head") ?? [], [0, 0, Math.sin(Math.PI / 8), Math.cos(Math.PI / 8)]);
  assertNear([pose.shapes.get("jawOpen") ?? -1, sampled(MOVING, 2).shapes.get("jawOpen") ?? -1], [0.5, 0.5]);
});

test("before the first key and after the last it stays as there, and a single key holds throughout", () => {
  assertNear(sampled(MOVING, -3).hipsM, [0, 1, 0]);
  assertNear([sampled(MOVING, 99).shapes.get("jawOpen") ?? -1], [0.5]);
  assertNear(sampled(clip(), 1.7).hipsM, [0, 1, 0]);
});

test("a blend is so much of the second pose, and what only one has is as there", () => {
  const still = sampled(clip({ shapes: new Map([["mouthClose", track(1, [0.8])]]) }), 0);
  const pose = blended(still, sampled(MOVING, 1), 0.25);
  assertNear(pose.hipsM, [0, 1, 0.5]);
  assert.equal(pose.shapes.get("jawOpen"), 1);
  assertNear([pose.shapes.get("mouthClose") ?? -1], [0.8]);
});
