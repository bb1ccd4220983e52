import assert from "node:assert/strict";
import { test } from "node:test";

import { draftOf, EMPTY, OPENED, PROJECT } from "../../../app/studio/page/state/project.js";
import { Store } from "../../../app/studio/page/state/store.js";
import { anotherTake, keepTake, nextName, nextSeed, takeOf, TAKES, useTake } from "../../../app/studio/page/takes/takes.js";

/** A store in which a line is open. */
function opened() {
  const store = new Store();
  store.set(OPENED, { id: "line", kept: { project: EMPTY, takes: [] } });
  return store;
}

test("a take is kept once, however often it is asked for", () => {
  const store = opened();
  assert.equal(keepTake(store), keepTake(store));
  assert.deepEqual(store.get(TAKES).map(({ name }) => name), ["Take 1"]);
});

test("another take keeps this one and has a seed that none has; the first can be used again, and that undone", () => {
  const store = opened();
  const first = anotherTake(store);
  assert.equal(store.get(PROJECT).options.seed, 1);
  useTake(store, first);
  assert.equal(takeOf(store.get(TAKES), draftOf(store.get(PROJECT))), first);
  store.history.undo();
  assert.equal(store.get(PROJECT).options.seed, 1);
});

test("names and seeds go on from the highest there is", () => {
  assert.equal(nextName([{ name: "Take 2" }, { name: "calm" }]), "Take 3");
  assert.equal(nextSeed([undefined, 4, 2]), 5);
});
