import assert from "node:assert/strict";
import { test } from "node:test";

import { FIRST } from "../../../app/studio/page/gesture_editor/gestures.js";
import { tracksOf, withoutTrack, withTrack, withTrackAdded } from "../../../app/studio/page/gesture_editor/tracks.js";
import { LANGUAGE } from "./small_language.js";

const ADDED = withTrackAdded(FIRST);

test("a track is added and removed", () => {
  assert.equal(tracksOf(ADDED).length, 1);
  assert.deepEqual(tracksOf(withoutTrack(ADDED, 0)), []);
  assert.deepEqual(tracksOf(FIRST), []);
});

test("only tracks that circle have turns", () => {
  const circling = withTrack(LANGUAGE, ADDED, 0, { form: "circling" });
  assert.equal(tracksOf(circling)[0]?.turns, 1);
  const [held] = tracksOf(withTrack(LANGUAGE, circling, 0, { form: "held", turns: 3, phase_deg: 90 }));
  assert.deepEqual([held?.turns, held?.phase_deg], [0, 0]);
});

test("angles and turns stay within their ranges, and a track that would turn nothing stays as it was", () => {
  assert.deepEqual(tracksOf(withTrack(LANGUAGE, ADDED, 0, { degrees: [90, -90, 0] }))[0]?.degrees, [45, -45, 0]);
  const [fastest] = tracksOf(withTrack(LANGUAGE, ADDED, 0, { form: "circling", turns: 9 }));
  assert.equal(fastest?.turns, 6);
  assert.equal(withTrack(LANGUAGE, ADDED, 0, { degrees: [0, 0, 0] }), ADDED);
});
