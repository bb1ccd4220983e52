import assert from "node:assert/strict";
import { test } from "node:test";

import { saidOf } from "../../../app/studio/page/reasons/sentences.js";
import { behavior, foundFunction, performance } from "../support/performances.js";

const why = (/** @type {Parameters<typeof behavior>[0]} */ given) =>
  saidOf(performance({ behaviors: [behavior(given)], functions: [foundFunction({ id: "f1" })] }), given.id)?.why;

test("a movement is there for what it means, what the author did, or so that the body is alive", () => {
  assert.equal(why({ id: "a", function: "f1" }), "“No,” is a no.");
  assert.equal(why({ id: "a", edit: 0 }), "You added it.");
  assert.match(why({ id: "a" }) ?? "", /^So that the body is alive/);
});

test("what an author chose is said beside what the performer would go by", () => {
  const stop = behavior({ id: "a", lexeme: "STOP", function: "f1", edit: 0 });
  const of = { channel: /** @type {const} */ ("gesture"), at: { word: 0 }, lexeme: "NEGATION" };
  const line = performance({ behaviors: [stop], functions: [foundFunction({ id: "f1" })] });
  assert.equal(saidOf(line, "a", { of, lexeme: "STOP" })?.why, "You chose “Stop” here. Left to itself, the performer would go by this: “No,” is a no.");
  assert.match(saidOf(line, "a", { of, hand: "left" })?.why ?? "", /^You changed it\. /);
});

test("what was dropped says why, in plain words", () => {
  const reason = "TILT_LEFT is worth more there than this (-3.0 in log-odds)";
  assert.equal(why({ id: "a", kept: false, reason }), "It is not made: “Tilt the head left” is worth more there than this.");
});

test("everything has a plain name, and the technical one beside it", () => {
  const said = saidOf(performance({ behaviors: [behavior({ id: "a", hand: "both" })] }), "a");
  assert.deepEqual([said?.name, said?.technical, said?.about], ["No", "gesture NEGATION, a", "Gestures · both hands · “No,”"]);
  assert.equal(saidOf(performance(), "word:1")?.name, "“never”");
  assert.equal(saidOf(performance(), "nothing"), null);
});
