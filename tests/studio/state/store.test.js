import assert from "node:assert/strict";
import { test } from "node:test";

import { slice } from "../../../app/studio/page/state/slice.js";
import { Store } from "../../../app/studio/page/state/store.js";

test("a slice has its initial value until another is set", () => {
  const store = new Store();
  const of = slice({ a: 1, b: 2 });
  assert.deepEqual(store.get(of), { a: 1, b: 2 });
  store.patch(of, { b: 3 });
  assert.deepEqual(store.get(of), { a: 1, b: 3 });
});

test("watchers are told at once and then of other values alone, until they stop", () => {
  const store = new Store();
  const of = slice(1);
  /** @type {number[]} */
  const told = [];
  const stop = store.watch(of, (value) => told.push(value));
  store.set(of, 2);
  store.set(of, 2);
  stop();
  store.set(of, 3);
  assert.deepEqual(told, [1, 2]);
});

test("values are frozen, and slices of other stores are not touched", () => {
  const of = slice({ a: 1 });
  const [one, other] = [new Store(), new Store()];
  one.set(of, { a: 2 });
  assert.throws(() => Object.assign(one.get(of), { a: 3 }), TypeError);
  assert.equal(other.get(of).a, 1);
});
