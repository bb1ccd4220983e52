import assert from "node:assert/strict";
import { mkdtemp, readdir } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { test } from "node:test";

import { Cache } from "../server/cache.js";

/** A cache in a new folder, and what counts how often something was made. */
async function counted() {
  const folder = await mkdtemp(join(tmpdir(), "npc-cache-"));
  let made = 0;
  const make = async () => {
    made += 1;
    return Uint8Array.of(made);
  };
  return { folder, cache: new Cache(folder), make, times: () => made };
}

test("what was made is kept, also for the next server; other parts are something else", async () => {
  const { folder, cache, make, times } = await counted();
  assert.deepEqual([...(await cache.kept(["a", "b"], make))], [1]);
  assert.deepEqual([...(await cache.kept(["a", "b"], make))], [1]);
  assert.deepEqual([...(await new Cache(folder).kept(["a", "b"], make))], [1]);
  assert.deepEqual([...(await cache.kept(["ab", ""], make))], [2]);
  assert.equal(times(), 2);
});

test("players who ask the same at once wait for one answer", async () => {
  const { cache, make, times } = await counted();
  await Promise.all([cache.kept(["a"], make), cache.kept(["a"], make), cache.kept(["a"], make)]);
  assert.equal(times(), 1);
});

test("a failure is not kept", async () => {
  const { folder, cache, make } = await counted();
  await assert.rejects(cache.kept(["a"], () => Promise.reject(new Error("full"))), /full/);
  assert.deepEqual([...(await cache.kept(["a"], make))], [1]);
  assert.equal((await readdir(folder)).length, 1);
});
