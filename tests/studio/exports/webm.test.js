import assert from "node:assert/strict";
import { test } from "node:test";

import { webm } from "../../../app/studio/page/exports/webm.js";

const HEAD = Uint8Array.from([...new TextEncoder().encode("OpusHead"), 1, 1, 0x38, 0x01, 0x80, 0xbb, 0, 0, 0, 0, 0]);

/** @param {number} time_ms */
const chunk = (time_ms, isKey = true) => ({ time_us: time_ms * 1000, isKey, data: Uint8Array.of(time_ms) });

/**
 * The elements in some bytes: ids of four bytes begin with 1, of three with 2 or 3, of two with 4 to 7, of one with 8 or
 * more; sizes are eight bytes long.
 *
 * @param {Uint8Array} bytes
 * @returns {{ id: string, at: number, content: Uint8Array }[]}
 */
function elements(bytes) {
  const found = [];
  for (let at = 0; at < bytes.length; ) {
    const first = bytes[at] ?? 0;
    const wide = Math.clz32(first) - 23;
    const size = Number(new DataView(bytes.buffer, bytes.byteOffset + at + wide).getBigUint64(0) & ((1n << 56n) - 1n));
    const content = bytes.subarray(at + wide + 8, at + wide + 8 + size);
    found.push({ id: Buffer.from(bytes.subarray(at, at + wide)).toString("hex"), at, content });
    at += wide + 8 + size;
  }
  return found;
}

test("a cluster begins at each key frame, has everything in order, and a cue says where it is", async () => {
  const pictures = { width_px: 1920, height_px: 1080, chunks: [chunk(0), chunk(33, false), chunk(66)] };
  const sound = { rate_hz: 48_000, channels: 1, head: HEAD, chunks: [chunk(20), chunk(60), chunk(80)] };
  const bytes = new Uint8Array(await webm(pictures, sound, 0.1).arrayBuffer());
  const [header, segment] = elements(bytes);
  assert.equal(header?.id, "1a45dfa3");
  const parts = elements(segment?.content ?? new Uint8Array());
  assert.deepEqual(parts.map(({ id }) => id), ["1549a966", "1654ae6b", "1f43b675", "1f43b675", "1c53bb6b"]);
  const clusters = parts.filter(({ id }) => id === "1f43b675");
  const blocks = clusters.map(({ content }) => elements(content).filter(({ id }) => id === "a3").map(({ content: block }) => [block[0], block[2], block[3], block[4]]));
  assert.deepEqual(blocks, [
    [[0x81, 0, 0x80, 0], [0x82, 20, 0x80, 20], [0x81, 33, 0, 33], [0x82, 60, 0x80, 60]],
    [[0x81, 0, 0x80, 66], [0x82, 14, 0x80, 80]],
  ]);
  const cues = elements(parts.at(-1)?.content ?? new Uint8Array()).map(({ content }) => elements(elements(content)[1]?.content ?? new Uint8Array())[1]);
  assert.deepEqual(cues.map((cue) => parseInt(Buffer.from(cue?.content ?? []).toString("hex"), 16)), clusters.map(({ at }) => at));
});

test("a film without a sound has one track", async () => {
  const bytes = new Uint8Array(await webm({ width_px: 2, height_px: 2, chunks: [chunk(0)] }, null, 1).arrayBuffer());
  const [, segment] = elements(bytes);
  const tracks = elements(segment?.content ?? new Uint8Array())[1];
  assert.equal(elements(tracks?.content ?? new Uint8Array()).length, 1);
});
