import assert from "node:assert/strict";
import { test } from "node:test";

import { latest } from "../../../app/studio/page/service/latest.js";

test("what is asked for while it is done is done once more, however often it was asked for", async () => {
  /** @type {(() => void)[]} */
  const ends = [];
  /** @type {boolean[]} */
  const were = [];
  const ask = latest(async (isLatest) => {
    await new Promise((resolve) => ends.push(() => resolve(undefined)));
    were.push(isLatest());
  });
  const done = ask();
  void ask();
  void ask();
  ends[0]?.();
  await new Promise((resolve) => setTimeout(resolve));
  ends[1]?.();
  await done;
  assert.deepEqual(were, [false, true]);
});
