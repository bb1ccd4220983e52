import assert from "node:assert/strict";
import { once } from "node:events";
import { mkdtemp } from "node:fs/promises";
import { request } from "node:http";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { UnderstudyClient } from "understudy-client";

import { Cache } from "../server/cache.js";
import { readDialogue } from "../server/dialogue.js";
import { Performances } from "../server/performances.js";
import { gameServer } from "../server/web.js";

/** @type {import("node:http").Server} */
let server;

before(async () => {
  const dialogue = await readDialogue();
  // Nothing listens at port 1.
  const client = new UnderstudyClient({ baseUrl: "http://127.0.0.1:1", retry: { retries: 0 } });
  const cache = new Cache(await mkdtemp(join(tmpdir(), "npc-web-")));
  server = gameServer(dialogue, new Performances(client, cache, dialogue)).listen(0, "127.0.0.1");
  await once(server, "listening");
});
after(() => server.close());

/**
 * The status and type that a path is answered, as it stands: fetch would take out its dots.
 *
 * @param {string} path
 * @returns {Promise<[number | undefined, string | undefined]>}
 */
async function got(path) {
  const { port } = /** @type {import("node:net").AddressInfo} */ (server.address());
  const asked = request({ port, path, host: "127.0.0.1", agent: false }).end();
  const [answer] = /** @type {[import("node:http").IncomingMessage]} */ (await once(asked, "response"));
  answer.resume();
  return [answer.statusCode, answer.headers["content-type"]];
}

test("the page, its libraries, the dialogue and the recordings are served with their types", async () => {
  assert.deepEqual(await got("/"), [200, "text/html; charset=utf-8"]);
  assert.deepEqual(await got("/three/three.module.js"), [200, "text/javascript"]);
  assert.deepEqual(await got("/three/addons/loaders/GLTFLoader.js"), [200, "text/javascript"]);
  assert.deepEqual(await got("/client/index.js"), [200, "text/javascript"]);
  assert.deepEqual(await got("/dialogue.json"), [200, "application/json"]);
  assert.deepEqual(await got("/lines/road.flac"), [200, "audio/flac"]);
});

test("nothing else of the machine is", async () => {
  for (const path of ["/package.json", "/page/../package.json", "/lines/make_lines.py", "/page/", "/performances/other.json"]) {
    assert.equal((await got(path))[0], 404, path);
  }
});

test("a service that does not answer is told as such", async () => {
  assert.deepEqual(await got("/performances/road.json"), [502, "application/json"]);
  assert.deepEqual(await got("/bodies/speaker.glb"), [502, "application/json"]);
});
