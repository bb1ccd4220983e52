import assert from "node:assert/strict";
import { test } from "node:test";

import { between, multiply, NO_TURN, rotate, shortestTurn, type Quaternion, type Vector } from "../../src/motion/vectors.js";
import { HALF, QUARTER_ABOUT_Z } from "../support/clips.js";
import { assertNear } from "../support/near.js";

const QUARTER_ABOUT_X: Quaternion = [HALF, 0, 0, HALF];

test("a quarter turn about Z takes X to Y, and the right factor of a product turns first", () => {
  assertNear(rotate(QUARTER_ABOUT_Z, [1, 0, 0]), [0, 1, 0]);
  assertNear(rotate(multiply(QUARTER_ABOUT_X, QUARTER_ABOUT_Z), [1, 0, 0]), [0, 0, 1]);
});

test("the shortest turn takes one direction to the other, even to its opposite", () => {
  const directions: Vector[] = [[1, 0, 0], [0, -2, 0], [-1, 0, 0], [0.3, 0.4, -0.5]];
  for (const from of directions) {
    for (const to of directions) {
      const turned = rotate(shortestTurn(from, to), from);
      const scale = Math.hypot(...from) / Math.hypot(...to);
      assertNear(turned, to.map((part) => part * scale));
    }
  }
  assert.deepEqual(shortestTurn([0, 0, 0], [1, 0, 0]), NO_TURN);
});

test("half of a quarter turn is an eighth, also where a key has the other sign", () => {
  const eighth = [0, 0, Math.sin(Math.PI / 8), Math.cos(Math.PI / 8)];
  assertNear(between(NO_TURN, QUARTER_ABOUT_Z, 0.5), eighth);
  assertNear(between(NO_TURN, [0, 0, -HALF, -HALF], 0.5), eighth);
  assertNear(between(QUARTER_ABOUT_Z, QUARTER_ABOUT_Z, 0.3), QUARTER_ABOUT_Z);
});
