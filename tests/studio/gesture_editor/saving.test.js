import assert from "node:assert/strict";
import { test } from "node:test";

import { withGesture } from "../../../app/studio/page/gesture_editor/saving.js";

const FILE = "# Small ones.\n\n# The first.\nGESTURECLASS beat\nGESTUREINSTANCE one\nDURATION 1\n\n# The second.\nGESTURECLASS beat\nGESTUREINSTANCE two\nDURATION 1\n";
const ONE = "GESTURECLASS beat\nGESTUREINSTANCE one\nDURATION 2\n";

test("a gesture takes the place of the one of its name, and what is around it stays", () => {
  assert.equal(withGesture(FILE, "one", ONE), FILE.replace("one\nDURATION 1", "one\nDURATION 2"));
  const two = ONE.replace("one", "two");
  assert.equal(withGesture(FILE, "two", two), FILE.replace("two\nDURATION 1", "two\nDURATION 2"));
});

test("another gesture comes to the end, and is all that a new file has", () => {
  const three = ONE.replace("one", "three");
  assert.equal(withGesture(FILE, "three", three), `${FILE}\n${three}`);
  assert.equal(withGesture("", "three", three), three);
});
