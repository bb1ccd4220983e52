import assert from "node:assert/strict";
import { test } from "node:test";

import { groupsOf, matching } from "../../../app/studio/page/rules/choosing_rules.js";
import { toldChanges } from "../../../app/studio/page/rules/telling_changes.js";

/** @import { Item } from "../../../app/studio/page/rules/rule_book.js" */
/** @import { LineChange } from "../../../app/studio/page/rules/telling_changes.js" */

/** @type {Item[]} */
const ITEMS = [
  { kind: "function", name: "big_yes", class: "affirmation", file: "a.rules", line: 1 },
  { kind: "word", name: "yes", class: "affirmation", subtype: "plain", file: "b.yaml", line: 2 },
  { kind: "bml", name: "big_nod", file: "c.yaml", line: 3 },
];

/** @param {readonly Item[]} items */
function names(items) {
  return items.map(({ name }) => name);
}

test("every word of the filter is in the name, the class, the subtype or the file", () => {
  assert.deepEqual(names(matching(ITEMS, "AFFIRM plain", "")), ["yes"]);
  assert.deepEqual(names(matching(ITEMS, "yaml", "")), ["yes", "big_nod"]);
  assert.deepEqual(names(matching(ITEMS, "", "")), names(ITEMS));
});

test("names that begin with the filter come first", () => {
  assert.deepEqual(names(matching(ITEMS, "yes", "")), ["yes", "big_yes"]);
});

test("a kind leaves out the others", () => {
  assert.deepEqual(names(matching(ITEMS, "big", "bml")), ["big_nod"]);
});

test("what a line no longer means is told in words, then what is likelier, then what is new", () => {
  const said = { id: "", class: "affirmation", subtype: "", text: "Yes,", first: 0, last: 0, priority: 5, rule: "big_yes", because: [], kept: true };
  const offered = { name: "big_nod", rule: "show", class: "affirmation", first: 0, last: 0, weight: 4 };
  /** @type {LineChange} */
  const change = { id: "", text: "", functions_before: [said], functions_after: [], offers_before: [offered], offers_after: [{ ...offered, weight: 9 }, { ...offered, name: "raise_brows", weight: 2 }] };
  assert.deepEqual(toldChanges(change), [
    { sign: "−", text: "“Yes,” is no longer read as a yes", technical: "affirmation, priority 5 (big_yes)" },
    { sign: "~", text: "Big nod, for a yes, is likelier", technical: "weight 4, then 9 (show)" },
    { sign: "+", text: "Raise brows, for a yes, is offered", technical: "weight 2 (show)" },
  ]);
});

test("items are in groups by what they are about, else by their file", () => {
  const items = [
    { kind: "function", name: "no", class: "negation", file: "functions/a.rules", line: 1 },
    { kind: "bml", name: "wave_off", file: "bml/own_moves.rules", line: 1 },
    { kind: "word", name: "never", class: "negation", file: "en/negation.yaml", line: 2 },
  ];
  assert.deepEqual(groupsOf(/** @type {Parameters<typeof groupsOf>[0]} */ (items)).map(({ name, items: found }) => [name, ...found.map((each) => each.name)]), [
    ["no", "no", "never"],
    ["own moves", "wave_off"],
  ]);
});
