import assert from "node:assert/strict";
import { test } from "node:test";

import { Pace } from "../../../app/studio/page/stage/detail.js";

/**
 * @param {Pace} pace
 * @param {number} from_ms
 * @param {number} frame_ms how long each frame takes
 * @param {number} length_ms
 */
function play(pace, from_ms, frame_ms, length_ms) {
  for (let now_ms = from_ms; now_ms < from_ms + length_ms; now_ms += frame_ms) {
    pace.frame(now_ms);
  }
}

test("what is slow becomes coarse within a second and a half, and stays so while it is neither slow nor quick", () => {
  const pace = new Pace(false);
  play(pace, 0, 16, 2000);
  assert.equal(pace.isCoarse, false);
  play(pace, 2000, 150, 1500);
  assert.equal(pace.isCoarse, true);
  play(pace, 4000, 30, 20_000);
  assert.equal(pace.isCoarse, true);
});

test("a single long frame and a pause change nothing", () => {
  const pace = new Pace(false);
  play(pace, 0, 16, 2000);
  pace.frame(2200);
  pace.frame(60_000);
  play(pace, 60_016, 16, 2000);
  assert.equal(pace.isCoarse, false);
});

test("quick coarse frames have all of it tried after four seconds, and after eight where that was slow", () => {
  const pace = new Pace(true);
  play(pace, 0, 16, 3000);
  assert.equal(pace.isCoarse, true);
  play(pace, 3000, 16, 2000);
  assert.equal(pace.isCoarse, false);
  play(pace, 5000, 150, 1500);
  assert.equal(pace.isCoarse, true);
  play(pace, 6500, 16, 6000);
  assert.equal(pace.isCoarse, true);
  play(pace, 12_500, 16, 4000);
  assert.equal(pace.isCoarse, false);
});
