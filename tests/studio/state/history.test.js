import assert from "node:assert/strict";
import { test } from "node:test";

import { ChangeProject } from "../../../app/studio/page/state/change_project.js";
import { DOABLE, History } from "../../../app/studio/page/state/history.js";
import { PROJECT } from "../../../app/studio/page/state/project.js";
import { Store } from "../../../app/studio/page/state/store.js";

/** A history whose time stands still until it is moved on. */
function fresh() {
  const store = new Store();
  const clock = { ms: 0 };
  const history = new History(store, () => clock.ms);
  const write = (/** @type {string} */ text) => history.execute(new ChangeProject(store, "Words", { text }));
  return { store, history, clock, write, text: () => store.get(PROJECT).text };
}

test("what was done is undone and done again, as often as one likes", () => {
  const { history, clock, write, text } = fresh();
  for (const [index, each] of ["a", "b", "c"].entries()) {
    clock.ms = 1000 * index;
    write(each);
  }
  history.undo();
  history.undo();
  assert.equal(text(), "a");
  history.redo();
  assert.equal(text(), "b");
  history.undo();
  history.undo();
  history.undo();
  assert.equal(text(), "");
});

test("after another change nothing can be done again", () => {
  const { store, history, clock, write, text } = fresh();
  write("a");
  history.undo();
  clock.ms = 1000;
  write("b");
  history.redo();
  assert.equal(text(), "b");
  assert.deepEqual(store.get(DOABLE), { undo: "Words", redo: null });
});

test("changes of the same within half a second are one", () => {
  const { history, clock, write, text } = fresh();
  write("a");
  clock.ms = 499;
  write("ab");
  clock.ms = 499 + 500;
  write("abc");
  assert.equal(history.toJSON().length, 2);
  history.undo();
  assert.equal(text(), "ab");
  history.undo();
  assert.equal(text(), "");
});

test("changes of different keys stay two", () => {
  const { store, history } = fresh();
  history.execute(new ChangeProject(store, "Words", { text: "a" }));
  history.execute(new ChangeProject(store, "Seed", { options: { seed: 3 } }));
  assert.equal(history.toJSON().length, 2);
});
