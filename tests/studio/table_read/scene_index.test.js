import assert from "node:assert/strict";
import { test } from "node:test";

import { castOf, namesIn, plainName, sceneOf } from "../../../app/studio/page/table_read/scene_index.js";

/** @import { IndexLine } from "../../../app/studio/page/table_read/scene_index.js" */

/** @type {IndexLine} */
const LINE = {
  id: "s1",
  character: "HENRY V",
  performer: "lively",
  text: "Once more.",
  audio: "/recordings/s1.flac",
  duration_s: 2.5,
  files: { "clip.json": "s1.clip.json", wav: "s1.wav" },
  listeners: { ELIZA: { "clip.json": "s1.ELIZA.clip.json" } },
};
const FILES = ["s1.clip.json", "s1.wav", "s1.ELIZA.clip.json"];

test("a line has its motion, its recording and its listeners", () => {
  const [line] = sceneOf({ lines: [LINE] }, new Set(FILES));
  assert.deepEqual(line, {
    id: "s1",
    speaker: "HENRY_V",
    performer: "lively",
    text: "Once more.",
    duration_s: 2.5,
    sound: "s1.wav",
    motion: "s1.clip.json",
    listeners: new Map([["ELIZA", "s1.ELIZA.clip.json"]]),
  });
});

test("the recording that was performed will do, and a GLB for the clip", () => {
  const line = { ...LINE, files: { glb: "s1.glb" } };
  const [found] = sceneOf({ lines: [line] }, new Set(["s1.glb", "audio/s1.flac"]));
  assert.deepEqual([found?.sound, found?.motion, found?.listeners.size], ["audio/s1.flac", "s1.glb", 0]);
});

test("what is missing is told with all lines that lack it", () => {
  const lines = [LINE, { ...LINE, id: "s2", files: { bml: "s2.bml" } }];
  assert.throws(() => sceneOf({ lines }, new Set(FILES)), /of s2; perform the batch with --format clip.json --format wav/);
  assert.throws(() => sceneOf({ lines: [] }, new Set()), /no lines/);
});

test("everybody is played by whom his own lines say", () => {
  const other = { ...LINE, character: "ELIZA", performer: "calm", listeners: {} };
  const lines = sceneOf({ lines: [LINE, other] }, new Set(FILES));
  assert.deepEqual([...castOf(lines)], [["HENRY_V", "lively"], ["ELIZA", "calm"]]);
  assert.deepEqual([...castOf(lines.slice(0, 1))], [["HENRY_V", "lively"], ["ELIZA", "default"]]);
});

test("names are those by which a batch calls listeners", () => {
  assert.deepEqual(["HENRY V", "?!", "1st Lord", "O'Brien", "Zoe\u0308", "JÖRG MÜLLER"].map(plainName), [
    "HENRY_V", "speaker", "L_1st_Lord", "O_Brien", "Zoë", "JÖRG_MÜLLER",
  ]);
});

test("what a scene is read from is named by its index", () => {
  const line = { ...LINE, files: { ...LINE.files, bml: "s1.bml" } };
  assert.deepEqual(namesIn({ lines: [line] }), ["s1.clip.json", "s1.wav", "s1.ELIZA.clip.json"]);
});
