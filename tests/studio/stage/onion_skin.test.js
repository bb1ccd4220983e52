import assert from "node:assert/strict";
import { test } from "node:test";

import { strokesAround } from "../../../app/studio/page/stage/onion_skin.js";

test("the skin is of the strokes before and after, not of the one that is seen", () => {
  assert.deepEqual(strokesAround([1, 2, 3], 2.5), [2, 3]);
  assert.deepEqual(strokesAround([1, 2, 3], 2.01), [1, 3]);
  assert.deepEqual(strokesAround([1, 2, 3], 0), [null, 1]);
  assert.deepEqual(strokesAround([1, 2, 3], 3), [2, null]);
});
