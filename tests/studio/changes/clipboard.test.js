import assert from "node:assert/strict";
import { test } from "node:test";

import { pasted } from "../../../app/studio/page/changes/clipboard.js";
import { behavior, performance } from "../support/performances.js";

test("a pasted movement is like the one that was copied, by its stroke at another word", () => {
  const copied = behavior({ id: "a", lexeme: "STOP", hand: "left", amount: 0.7 });
  const edit = pasted(performance(), copied, 0.5);
  assert.deepEqual([edit.add, edit.lexeme, edit.hand, edit.amount, edit.on?.word], ["gesture", "STOP", "left", 0.7, 1]);
  assert.equal(edit.marks?.stroke?.offset_s, -0.2);
});
