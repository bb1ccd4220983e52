import assert from "node:assert/strict";
import { test } from "node:test";

import { strongest } from "../../../app/studio/page/naming/tones.js";

test("a voice has most of the tone with the largest share; where none is told it is neutral", () => {
  assert.deepEqual(strongest({ neutral: 0.2, sad: 0.7, angry: 0.1 }), ["sad", 0.7]);
  assert.deepEqual(strongest({}), ["neutral", 1]);
});
