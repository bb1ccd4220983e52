import assert from "node:assert/strict";
import { test } from "node:test";

import { feelingItems, focusItems } from "../../../app/studio/page/timeline/listening_tracks.js";
import { performance } from "../support/performances.js";

const TONES = { neutral: 0.2, happy: 0, sad: 0.7, angry: 0.1, afraid: 0, disgusted: 0, surprised: 0 };
const MEASURED = { activation: -0.4, valence: -0.5, dominance: 0, tones: TONES };

test("each phrase has the tone that its voice has most of", () => {
  const line = performance({ affect: { ...MEASURED, phrases: [{ ...MEASURED, first: 0, last: 1 }] } });
  const [item] = feelingItems(line);
  assert.deepEqual([item?.label, item?.start_s, item?.end_s], ["Sad", 0, 1]);
  assert.match(item?.technical ?? "", /valence -0.50/);
  assert.deepEqual(feelingItems(performance()), []);
});

test("the focus is on words by their share of the largest; hardly any is none", () => {
  const line = performance({ focus: [{ word: 0, share: 0.02 }, { word: 1, share: 0.6 }] });
  assert.deepEqual(focusItems(line).map(({ id, share }) => [id, share]), [["word:1", 1]]);
});
