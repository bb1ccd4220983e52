import assert from "node:assert/strict";
import { test } from "node:test";

import { Answers } from "../../../app/study/page/answers.js";

/** @import { Plan } from "../../../app/study/page/plan.js" */

/** @param {"modes" | "units"} comparison */
function planOf(comparison) {
  return /** @type {Plan} */ ({ name: "n", comparison });
}

function fresh() {
  const texts = new Map();
  return {
    getItem: (/** @type {string} */ name) => texts.get(name) ?? null,
    setItem: (/** @type {string} */ name, /** @type {string} */ text) => void texts.set(name, text),
  };
}

test("answers are a row each, with their columns in order", () => {
  const answers = new Answers(planOf("modes"), 7, fresh());
  answers.keep(0, [{ position: 1, clip: "x", rating: 9, choice: "best" }, { position: 2, clip: "y", rating: 2, choice: "" }]);
  assert.equal(answers.csv(), "rater,trial,position,clip,rating,choice\n7,1,1,x,9,best\n7,1,2,y,2,\n");
});

test("answers of an earlier visit are there again, for the same rater of the same study alone", () => {
  const store = fresh();
  new Answers(planOf("units"), 7, store).keep(2, [{ a: "x", b: "y", dimension: "natural", answer: "A" }]);
  const again = new Answers(planOf("units"), 7, store);
  assert.deepEqual([again.count, again.has(0), again.has(2)], [1, false, true]);
  assert.equal(again.csv(), "rater,trial,a,b,dimension,answer\n7,3,x,y,natural,A\n");
  assert.equal(new Answers(planOf("units"), 8, store).count, 0);
});

test("cells that need it are quoted", () => {
  const answers = new Answers(planOf("modes"), 1, fresh());
  answers.keep(0, [{ position: 1, clip: 'a,"b"', rating: 1, choice: "" }]);
  assert.ok(answers.csv().includes('1,1,1,"a,""b""",1,'));
});
