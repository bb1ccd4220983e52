import assert from "node:assert/strict";
import { test } from "node:test";

import { movedWith } from "../../../app/studio/page/changes/moving.js";
import { PERFORMED, SELECTION } from "../../../app/studio/page/state/performed.js";
import { Store } from "../../../app/studio/page/state/store.js";
import { LOOKS } from "../../../app/studio/page/timeline/looks.js";
import { MARKED } from "../../../app/studio/page/timeline/selecting.js";
import { behavior, performance } from "../support/performances.js";

/** @import { PerformedLine } from "../../../app/studio/page/state/performed.js" */

const FIRST = behavior({ id: "first", start_s: 0 });
const SECOND = behavior({ id: "second", start_s: 2 });
const THIRD = behavior({ id: "third", start_s: 4 });
const NOD = behavior({ id: "nod", kind: "head", lexeme: "NOD", start_s: 5 });

function looked() {
  const store = new Store();
  const line = { performance: performance({ behaviors: [FIRST, SECOND, THIRD, NOD] }), edits: null };
  store.set(PERFORMED, /** @type {PerformedLine} */ (/** @type {unknown} */ (line)));
  return store;
}

/** @param {ReturnType<typeof movedWith>} moved */
const ids = (moved) => moved.map(({ id }) => id);

test("what is selected moves together, and alone what is not", () => {
  const store = looked();
  store.set(SELECTION, "first");
  store.set(MARKED, ["nod"]);
  assert.deepEqual(ids(movedWith(store, [NOD])), ["first", "nod"]);
  assert.deepEqual(ids(movedWith(store, [THIRD])), ["third"]);
});

test("while the timeline ripples, what comes later in the same row moves along", () => {
  const store = looked();
  store.patch(LOOKS, { ripple: true });
  assert.deepEqual(ids(movedWith(store, [SECOND])), ["second", "third"]);
  assert.deepEqual(ids(movedWith(store, [NOD])), ["nod"]);
});
