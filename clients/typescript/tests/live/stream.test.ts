/** A live stream against the real service. */

import assert from "node:assert/strict";
import { after, before, describe, test } from "node:test";

import type { LocalService } from "../../src/node/local_service.js";
import { ConnectionError, ServiceProblemError } from "../../src/service/errors.js";
import type { LiveMessage } from "../../src/live/messages.js";
import { LiveStream } from "../../src/live/stream.js";
import { noService, startService } from "../support/service.js";

const KEY = "a-key-of-sixteen-letters";
const RATE_HZ = 16_000;

/** A voice that hums for half a second and is silent for half a second, three times. */
function hums(): Float32Array {
  return Float32Array.from({ length: 3 * RATE_HZ }, (_, at) => {
    const loud = at % RATE_HZ < RATE_HZ / 2 ? 0.3 : 0;
    return loud * (Math.sin((2 * Math.PI * 140 * at) / RATE_HZ) + 0.5 * Math.sin((2 * Math.PI * 280 * at) / RATE_HZ));
  });
}

describe("a live stream", { skip: noService }, () => {
  let service: LocalService;

  before(async () => {
    service = await startService({ UNDERSTUDY_API_KEYS: KEY });
  });
  after(() => service.stop());

  test("sound goes in, messages come out until it is done", async () => {
    const stream = await LiveStream.open({ baseUrl: service.baseUrl, apiKey: KEY }, { frames: 30 });
    const joints = stream.ready.joints ?? [];
    assert.equal(joints[0], "hips");
    const told: LiveMessage[] = [];
    const reading = (async () => {
      for await (const message of stream) {
        told.push(message);
      }
    })();
    const voice = hums();
    for (let at = 0; at < voice.length; at += 640) {
      stream.send(voice.subarray(at, at + 640));
    }
    stream.sendSilence(0.5);
    stream.sendWords({ text: "No, not those." });
    stream.end();
    await reading;
    assert.equal(stream.duration_s, 3.5);
    const frame = told.find((message) => message.type === "frame");
    assert.equal(frame?.rotations.length, 4 * joints.length);
    assert.ok(told.some(({ type }) => type === "mouth"));
  });

  test("what the service refuses is a problem with its code", async () => {
    const address = { baseUrl: service.baseUrl, apiKey: KEY };
    await assert.rejects(LiveStream.open(address, { character: "nobody" }), (error) => {
      assert.ok(error instanceof ServiceProblemError);
      assert.match(error.detail, /nobody/);
      return true;
    });
  });

  test("words that cannot be used are told, and the stream goes on", async () => {
    const stream = await LiveStream.open({ baseUrl: service.baseUrl, apiKey: KEY });
    stream.sendWords({ words: [{ text: "no", start_s: 2, end_s: 1 }] });
    stream.end();
    const told: LiveMessage[] = [];
    for await (const message of stream) {
      told.push(message);
    }
    assert.deepEqual(told.map(({ type }) => type), ["error"]);
  });

  test("without the key there is no stream", async () => {
    await assert.rejects(LiveStream.open({ baseUrl: service.baseUrl }), ConnectionError);
  });
});

test("where nothing listens, that is said", async () => {
  await assert.rejects(LiveStream.open({ baseUrl: "http://127.0.0.1:9" }), ConnectionError);
});
