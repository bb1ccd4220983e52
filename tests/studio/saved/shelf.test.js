import assert from "node:assert/strict";
import { test } from "node:test";

import { mayBeLost } from "../../../app/studio/page/saved/autosave.js";
import { isDue } from "../../../app/studio/page/saved/shelf.js";

test("a version is kept at once, and then when some time has passed", () => {
  assert.ok(isDue(undefined, 0));
  assert.ok(!isDue({ saved_ms: 1000 }, 20_999));
  assert.ok(isDue({ saved_ms: 1000 }, 21_000));
});

test("the page asks before it goes only where a change is not kept", () => {
  assert.deepEqual(/** @type {const} */ (["same", "unsaved", "saved", "failed"]).map(mayBeLost), [false, true, false, true]);
});
