import assert from "node:assert/strict";
import { test } from "node:test";

import { sectionsOn } from "../../../app/studio/page/reasons/telling.js";
import { behavior, foundFunction, performance } from "../support/performances.js";

const MOMENT = {
  id: "m1",
  channel: "gesture",
  first: 0,
  last: 0,
  stroke: 0,
  families: ["negation", "stop"],
  shares: [0.7, 0.1],
  importance: 0.6,
  terms: [{ name: "how common it is", weight: -0.5 }],
  rejected: [{ families: ["stop"], worth: 0.1, reason: "negation is worth more" }],
};
const LINE = performance({
  functions: [foundFunction({ id: "f1" }), foundFunction({ id: "f2", kept: false, lost_to: "f1" })],
  behaviors: [
    behavior({ id: "a", rule: "show_negation", function: "f1", moment: "m1" }),
    behavior({ id: "b", kept: false, lost_to: "a", reason: "too close" }),
  ],
  moments: [MOMENT],
});

/** All texts on something, and all that they select. */
function told(/** @type {string} */ id) {
  const sections = sectionsOn(LINE, id);
  return {
    titles: sections.map(({ title }) => title),
    texts: sections.flatMap((section) => section.told.map(({ text }) => text)),
    ids: sections.flatMap((section) => section.told.flatMap((each) => each.id ?? [])),
    rules: sections.flatMap((section) => section.told.flatMap((each) => each.rule ?? [])),
  };
}

test("a behaviour tells its words, rule, function, terms and what lost to it", () => {
  const { titles, texts, ids, rules } = told("a");
  assert.equal(titles[0], "gesture NEGATION");
  assert.deepEqual(ids, ["word:0", "f1", "b"]);
  assert.deepEqual(rules, ["show_negation"]);
  assert.ok(texts.includes("−0.50  how common it is"));
  assert.ok(texts.includes("stop (0.10): negation is worth more"));
});

test("what was dropped says why, and to what", () => {
  assert.deepEqual(told("b").ids, ["word:0", "a"]);
  assert.ok(told("b").texts.includes("too close"));
});

test("a function tells the words and rule that it comes from, and what shows it", () => {
  assert.deepEqual(told("f1").ids, ["word:0", "word:0", "a", "f2"]);
  assert.deepEqual(told("f1").rules, ["negation_word"]);
});

test("a word tells what is meant and done on it; of what is not there nothing is told", () => {
  assert.deepEqual(told("word:0").ids, ["f1", "f2", "a", "b"]);
  assert.deepEqual(told("word:7").titles, []);
  assert.deepEqual(told("gesture99").titles, []);
});
