import assert from "node:assert/strict";
import { test } from "node:test";

import { eyesSeenBy, readDialogue, readRecording } from "../server/dialogue.js";

/** @type {(place: [number, number, number], faces_deg: number) => import("../server/dialogue.js").Npc} */
const standing = (place, faces_deg) => ({ name: "x", character: "default", place, faces_deg });

test("another's eyes are seen from where an NPC stands and faces", () => {
  const near = (/** @type {number[]} */ found, /** @type {number[]} */ expected) =>
    found.forEach((part, axis) => assert.ok(Math.abs(part - (expected[axis] ?? 0)) < 1e-9, `${found} is not ${expected}`));
  near(eyesSeenBy(standing([0, 0, 0], 0), { place: [1, 0, 2] }), [1, 1.6, 2]);
  // Turned to +X, what lies at +X is ahead, and what lies at +Z is to the right, at -X.
  near(eyesSeenBy(standing([0, 0, 0], 90), { place: [2, 0, 0] }), [0, 1.6, 2]);
  near(eyesSeenBy(standing([1, 0, 0], 90), { place: [1, 0, 3] }), [-3, 1.6, 0]);
});

test("every line of the dialogue has been recorded", async () => {
  const { lines } = await readDialogue();
  const recordings = await Promise.all(lines.map(readRecording));
  for (const recording of recordings) {
    assert.equal(new TextDecoder().decode(recording.subarray(0, 4)), "fLaC");
  }
});
