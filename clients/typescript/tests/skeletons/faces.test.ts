import assert from "node:assert/strict";
import { test } from "node:test";

import type { Pose } from "../../src/motion/clip.js";
import { shownWeights } from "../../src/skeletons/faces.js";

const POSE: Pose = {
  hipsM: [0, 1, 0],
  turns: new Map(),
  shapes: new Map([["jawOpen", 0.5], ["mouthClose", 0.1], ["eyeLookUpLeft", 0.2], ["browInnerUp", 0.3]]),
  visemes: new Map([["aa", 0.9]]),
};

function shown(shapes: string[], eyeLook = false): Record<string, number> {
  return Object.fromEntries(shownWeights(POSE, new Set(shapes), { eyeLook }));
}

test("a face with ARKit's shapes gets those that it has, and no visemes, which would open the mouth twice", () => {
  assert.deepEqual(shown(["jawOpen", "browInnerUp", "viseme_aa"]), { jawOpen: 0.5, browInnerUp: 0.3 });
});

test("a face without a jaw of ARKit's speaks by visemes, with or without their prefix", () => {
  assert.deepEqual(shown(["viseme_aa", "mouthClose", "browInnerUp"]), { viseme_aa: 0.9, browInnerUp: 0.3 });
  assert.deepEqual(shown(["aa"]), { aa: 0.9 });
});

test("eyes that bones turn are not turned by shapes besides", () => {
  assert.deepEqual(shown(["eyeLookUpLeft"]), {});
  assert.deepEqual(shown(["eyeLookUpLeft"], true), { eyeLookUpLeft: 0.2 });
});
