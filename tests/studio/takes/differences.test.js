import assert from "node:assert/strict";
import { test } from "node:test";

import { differences, toldDifferences } from "../../../app/studio/page/takes/differences.js";
import { behavior, performance } from "../support/performances.js";

test("movements are the same where they do the same at the same time; what was dropped does not count", () => {
  const both = behavior({ id: "a" });
  const line = { performance: performance({ behaviors: [both, behavior({ id: "b", start_s: 1 })] }) };
  const gone = behavior({ id: "d", start_s: 2, kept: false });
  const other = { performance: performance({ behaviors: [{ ...both, id: "x" }, behavior({ id: "y", start_s: 3 }), gone] }) };
  const found = differences(line, other);
  assert.deepEqual([found.same, found.here.map(({ id }) => id), found.there.map(({ id }) => id)], [1, ["b"], ["y"]]);
  assert.equal(toldDifferences(found), "1 movements are the same; 1 only here, 1 only there.");
});
