import assert from "node:assert/strict";
import { test } from "node:test";

import { letter, roundsOf } from "../../../app/study/page/plan.js";

/** @import { Plan } from "../../../app/study/page/plan.js" */

/** @type {Plan} */
const PLAN = {
  name: "n",
  comparison: "modes",
  lines: [
    { sound: "s0", body: "b", clips: ["x", "y"] },
    { sound: "s1", body: "b", clips: ["v", "w"] },
  ],
  orders: [
    [[0, [0, 1]], [1, [1, 0]]],
    [[1, [0, 1]], [0, [1, 0]]],
  ],
  grades: [1, 10],
  much: 2,
  training: [],
  dimensions: ["natural"],
  undecided: "undecided",
  understood: ["understood", 3],
};

test("raters take the orders in turn, and again from the first", () => {
  const clips = (/** @type {number} */ rater) => roundsOf(PLAN, rater).map((round) => round.clips.join(""));
  assert.deepEqual(clips(1), ["xy", "wv"]);
  assert.deepEqual(clips(2), ["vw", "yx"]);
  assert.deepEqual(clips(3), clips(1));
});

test("of speakers a clip is seen alone first, then two side by side", () => {
  const rounds = roundsOf({ ...PLAN, comparison: "speakers" }, 1);
  assert.deepEqual(
    rounds.map((round) => round.clips.join("")),
    ["x", "w", "xy", "wv"],
  );
});

test("clips are called by letters", () => {
  assert.deepEqual([0, 1, 2].map(letter), ["A", "B", "C"]);
});
