import assert from "node:assert/strict";
import { test } from "node:test";

import { strToU8, zipSync } from "fflate";

import { unzipped } from "../../../app/studio/page/exports/zip_files.js";

test("a zip of the limit is unpacked and one byte more is refused before it is", () => {
  const whole = zipSync({ "a.txt": new Uint8Array(2 ** 20) });
  assert.ok(whole.length < 5000);
  assert.equal(unzipped("a.zip", whole, 1)["a.txt"]?.length, 2 ** 20);
  const more = zipSync({ "a.txt": new Uint8Array(2 ** 20), "b.txt": strToU8("b") });
  assert.throws(() => unzipped("a.zip", more, 1), /a\.zip unpacks to more than 1 MB/);
});

test("a file that unpacks to more than its zip says is cut off there", () => {
  const lying = zipSync({ "a.txt": new Uint8Array(2 ** 20) });
  const view = new DataView(lying.buffer, lying.byteOffset, lying.byteLength);
  for (let at = 0; at < lying.length - 46; at += 1) {
    if (view.getUint32(at, true) === 0x02014b50) {
      view.setUint32(at + 24, 10, true);
    }
  }
  let bytes = 10;
  try {
    bytes = unzipped("a.zip", lying)["a.txt"]?.length ?? 0;
  } catch {
    bytes = 0;
  }
  assert.ok(bytes <= 10, String(bytes));
});

test("what is no zip says so", () => {
  assert.throws(() => unzipped("a.zip", strToU8("no zip")), /a\.zip is not a zip that can be opened/);
});
