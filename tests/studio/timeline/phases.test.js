import assert from "node:assert/strict";
import { test } from "node:test";

import { MARKS, phasesOf, playedSync } from "../../../app/studio/page/timeline/phases.js";

test("seven marks make five phases, the holds around the stroke", () => {
  const sync = Object.fromEntries(MARKS.map((mark, index) => [mark, index]));
  assert.deepEqual(
    phasesOf(sync).map(({ name, start_s, end_s }) => [name, start_s, end_s]),
    [["preparation", 0, 1], ["hold", 1, 2], ["stroke", 2, 4], ["hold", 4, 5], ["retraction", 5, 6]],
  );
});

test("a phase that takes no time is none, and neither is one whose marks are missing", () => {
  assert.deepEqual(phasesOf({ start: 0, ready: 1, stroke_start: 1, end: 2 }), [{ name: "preparation", start_s: 0, end_s: 1 }]);
});

test("phases can be those that are played, of a behaviour alone", () => {
  const events = [
    { behavior: "gesture1", point: "start", timeS: 0.1 },
    { behavior: "head1", point: "start", timeS: 0 },
    { behavior: "gesture1", point: "ready", timeS: 0.4 },
  ];
  assert.deepEqual(phasesOf(playedSync(events, "gesture1")), [{ name: "preparation", start_s: 0.1, end_s: 0.4 }]);
  assert.deepEqual(phasesOf(playedSync(events, "gesture2")), []);
});
