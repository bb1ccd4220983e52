import assert from "node:assert/strict";
import { test } from "node:test";

import { isClear, roundFrom } from "../../../app/studio/page/stage/framing.js";
import { facing, marksOf } from "../../../app/studio/page/table_read/marks.js";
import { viewOf } from "../../../app/studio/page/table_read/shots.js";

const PICTURE = { eyes_m: 1.6, aspect: 1.6 };
const SHOTS = /** @type {const} */ (["wide", "medium", "close", "two_shot", "over_shoulder"]);

/**
 * Whoever speaks, facing whom he speaks to, who comes first of the others.
 *
 * @param {number} count of people
 * @param {number} speaking
 * @param {number} heard
 */
function scene(count, speaking, heard) {
  const marks = marksOf(Array.from({ length: count }, (_, place) => `n${String(place)}`));
  const names = [...marks.keys()];
  const [speaker = "", listener = ""] = [names[speaking], names[heard]];
  const { body_rad } = facing(speaker, { speaker, listeners: [listener] }, marks);
  const mark = (/** @type {string} */ name) => marks.get(name) ?? { x: NaN, z: NaN };
  const rest = names.filter((name) => name !== speaker && name !== listener);
  return { subject: { ...mark(speaker), facing_rad: body_rad }, others: [listener, ...rest].map(mark) };
}

test("nobody is shown from behind, whoever speaks to whom", () => {
  for (const count of [2, 3, 4, 5]) {
    for (const shot of SHOTS) {
      for (let speaking = 0; speaking < count; speaking++) {
        const { subject, others } = scene(count, speaking, (speaking + 1) % count);
        const round = roundFrom(viewOf(shot, subject, others, PICTURE), subject);
        assert.ok(round < 1.66, `${shot} ${String(speaking)} of ${String(count)}: ${String(round)}`);
      }
    }
  }
});

test("of two, nobody stands before whoever speaks, and the camera is on the audience's side", () => {
  for (const shot of SHOTS) {
    for (const speaking of [0, 1]) {
      const { subject, others } = scene(2, speaking, 1 - speaking);
      const view = viewOf(shot, subject, others, PICTURE);
      assert.ok(shot === "over_shoulder" || isClear(view, subject, others), shot);
      assert.ok(view.from_m[2] > 0.3, `${shot}: ${view.from_m.join(" ")}`);
    }
  }
});

test("the wide shot is from the audience where the face is seen from there, and has everybody in it", () => {
  const { subject, others } = scene(2, 0, 1);
  const { from_m, at_m } = viewOf("wide", subject, others, PICTURE);
  assert.deepEqual([from_m[0], at_m[0], at_m[2]], [0, 0, 0]);
});
