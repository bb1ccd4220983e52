import assert from "node:assert/strict";
import { test } from "node:test";

import { kindOf, refusalOf } from "../../../app/studio/page/line/kinds.js";
import { wavOf } from "../../../app/studio/page/line/wav.js";

test("files are known by their endings", () => {
  assert.deepEqual(["a.WAV", "b.txt", "c.vrm", "d.studio.zip", "e.edits.json", "f.yaml", "g"].map(kindOf), ["audio", "text", "body", "project", "edits", null, null]);
});

test("what a line has no use for is told where it belongs", () => {
  assert.match(refusalOf("words.yaml"), /^words\.yaml: rules and word lists are edited under Rules/);
  assert.match(refusalOf("notes.docx"), /not known; a line is made of a recording/);
});

test("a recording is a WAV of 16 bits, and what is too loud is clipped", () => {
  const bytes = wavOf(Float32Array.of(0, 0.5, -2), 48_000);
  const view = new DataView(bytes.buffer);
  assert.equal(new TextDecoder().decode(bytes.slice(0, 4)), "RIFF");
  assert.deepEqual([view.getUint32(4, true), view.getUint32(24, true), view.getUint32(40, true)], [bytes.length - 8, 48_000, 6]);
  assert.deepEqual([44, 46, 48].map((at) => view.getInt16(at, true)), [0, 16384, -32767]);
});
