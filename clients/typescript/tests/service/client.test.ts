/** The client against the real service. */

import assert from "node:assert/strict";
import { after, before, describe, test } from "node:test";

import type { LocalService } from "../../src/node/local_service.js";
import { UnderstudyClient } from "../../src/service/client.js";
import { ServiceProblemError } from "../../src/service/errors.js";
import { noService, recorded, startService } from "../support/service.js";

const KEY = "a-key-of-sixteen-letters";

describe("the client and the service", { skip: noService }, () => {
  let service: LocalService;
  let client: UnderstudyClient;

  before(async () => {
    service = await startService({ UNDERSTUDY_API_KEYS: KEY, UNDERSTUDY_QUEUE: "0" });
    client = new UnderstudyClient({ baseUrl: service.baseUrl, apiKey: KEY, timeoutMs: 60_000 });
  });
  after(() => service.stop());

  test("a line is performed, with a listener", async () => {
    const line = await recorded("figure8");
    const { bml, performance, listeners } = await client.perform({ ...line, options: { seed: 3, listener: ["bob"] } });
    assert.match(bml, /^<\?xml|<bml/);
    assert.deepEqual(performance.words.map(({ text }) => text), line.text.split(/\s+/));
    assert.equal(performance.seed, 3);
    assert.match(listeners?.["bob"] ?? "", /<bml/);
  });

  test("every part of the form reaches the service", async () => {
    const line = await recorded("figure8");
    const words = line.text.split(/\s+/).map((text, index) => ({ text, index, start_s: index / 5, end_s: index / 5 + 0.1 }));
    const { performance } = await client.perform({
      ...line,
      words: { name: "words.json", content: new TextEncoder().encode(JSON.stringify({ words })) },
      functions: [{ class: "negation", first: 1, last: 2 }],
      direction: { moments: [{ first: 8, last: 9, head: ["shake"] }] },
      edits: { version: 1, line: { agitation: "high" } },
    });
    assert.equal(performance.agitation, "high");
    assert.equal(performance.words[1]?.start_s, 0.2);
    assert.ok(performance.moments.some((moment) => moment.first === 8 && moment.note === 0));
    assert.ok(performance.functions.some((found) => found.class === "negation" && found.first === 1 && found.last === 2));
  });

  test("BML alone, and its motion as a clip, GLB and BVH", async () => {
    const line = await recorded("figure8");
    const { content: bml } = await client.performBml(line);
    const clip = await client.realize({ bml, audio: line.audio, options: { fps: 30 } });
    assert.equal(clip.format, "understudy-clip");
    assert.ok(clip.frames > 30);
    const { content: glb } = await client.realizeGlb({ bml, audio: line.audio });
    assert.equal(new TextDecoder().decode(glb.slice(0, 4)), "glTF");
    const { content: bvh } = await client.realizeBvh({ bml, options: { skeleton: "mixamo" } });
    assert.match(bvh, /^HIERARCHY/);
  });

  test("a motion model moves the body, by the scenario that is named", async () => {
    const line = await recorded("figure8");
    const { content: bml } = await client.performBml(line);
    const played = { bml, audio: line.audio };
    const { content: plain } = await client.realizeBvh(played);
    const { content: moved } = await client.realizeBvh({ ...played, motion_model: "default", scenario: "S2" });
    assert.match(moved, /^HIERARCHY/);
    assert.notEqual(moved, plain);
    await assert.rejects(client.realizeBvh({ ...played, motion_model: "default", scenario: "S9" }), ServiceProblemError);
  });

  test("words, and what the service knows", async () => {
    const { functions } = await client.findFunctions("No, I have never seen those.");
    assert.ok(functions.some((found) => found.class === "negation"));
    const { characters } = await client.listCharacters();
    assert.ok(characters.length > 0);
    assert.ok((await client.listGestures()).gestures.length > 0);
    assert.ok((await client.listRules()).rules.length > 0);
    assert.ok((await client.listWords()).rules.length > 0);
    assert.equal((await client.status()).status, "ready");
  });

  test("a mistake is told with its code and field", async () => {
    const { audio } = await recorded("figure8");
    await assert.rejects(
      client.perform({ audio, text: "  " }),
      (error) => error instanceof ServiceProblemError && error.code === "text_empty" && error.field === "text",
    );
    await assert.rejects(
      client.perform({
        ...(await recorded("figure8")),
        profile: { name: "anna.yaml", content: new TextEncoder().encode("a: [") },
      }),
      (error) => error instanceof ServiceProblemError && error.code === "profile_wrong" && error.field === "profile",
    );
    await assert.rejects(
      client.perform({ ...(await recorded("figure8")), rules: { files: { "en/nowhere.yaml": "" } } }),
      (error) => error instanceof ServiceProblemError && error.status === 422 && error.detail.includes("nowhere"),
    );
    await assert.rejects(
      new UnderstudyClient({ baseUrl: service.baseUrl }).listCharacters(),
      (error) => error instanceof ServiceProblemError && error.status === 401 && error.code === "key_wrong",
    );
  });

  test("two lines at once at a service with one worker and no queue are both performed, the second at a later attempt", async () => {
    const line = await recorded("figure8");
    let asked = 0;
    const counting: typeof fetch = (url, request) => {
      asked += 1;
      return fetch(url, request);
    };
    const patient = new UnderstudyClient({ baseUrl: service.baseUrl, apiKey: KEY, fetch: counting });
    // On a busy machine the first may be done before the second arrives; then they are sent again.
    let sent = 0;
    while (asked === sent && sent < 40) {
      sent = asked + 2;
      const performed = await Promise.all([patient.perform(line), patient.perform(line)]);
      assert.ok(performed.every(({ bml }) => bml.includes("<bml")));
    }
    assert.ok(asked > sent);
  });
});
