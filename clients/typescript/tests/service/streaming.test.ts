import assert from "node:assert/strict";
import { after, before, describe, test } from "node:test";

import type { LocalService } from "../../src/node/local_service.js";
import { UnderstudyClient } from "../../src/service/client.js";
import { ServiceProblemError } from "../../src/service/errors.js";
import { performEach, type PerformedLine } from "../../src/service/streaming.js";
import type { PerformRequest } from "../../src/service/types.js";
import { answering, problem } from "../support/server.js";
import { noService, recorded, startService } from "../support/service.js";

test("no more lines are taken than are under way, whoever reads slowly", async () => {
  const server = await answering({ status: 200, body: { bml: "<bml/>" } });
  const client = new UnderstudyClient({ baseUrl: server.baseUrl });
  let taken = 0;
  function* endless(): Generator<PerformRequest> {
    for (;;) {
      taken += 1;
      yield { audio: new ArrayBuffer(0), text: String(taken) };
    }
  }
  const texts: string[] = [];
  for await (const { line } of performEach(client, endless(), { concurrency: 3 })) {
    texts.push(line.text);
    if (texts.length === 4) {
      break;
    }
  }
  server.stop();
  assert.deepEqual(texts, ["1", "2", "3", "4"]);
  assert.equal(taken, 6);
});

test("a line that fails is told as such, and the next goes on", async () => {
  const server = await answering(problem(422, "text_empty"), { status: 200, body: { bml: "<bml/>" } });
  const client = new UnderstudyClient({ baseUrl: server.baseUrl });
  const lines = ["", "No."].map((text) => ({ audio: new ArrayBuffer(0), text }));
  const found: PerformedLine[] = [];
  for await (const performed of performEach(client, lines, { concurrency: 1 })) {
    found.push(performed);
  }
  server.stop();
  assert.deepEqual(found.map(({ result }) => result.status), ["rejected", "fulfilled"]);
  const [first] = found;
  assert.ok(first?.result.status === "rejected" && first.result.reason instanceof ServiceProblemError);
});

describe("lines streamed through the service", { skip: noService }, () => {
  let service: LocalService;

  before(async () => {
    service = await startService({ UNDERSTUDY_WORKERS: "2" });
  });
  after(() => service.stop());

  test("come in the order in which they were given, the longest first too", async () => {
    const lines = await Promise.all(["numbers", "figure8", "figure8"].map(recorded));
    const client = new UnderstudyClient({ baseUrl: service.baseUrl });
    const texts: string[] = [];
    for await (const { line, result } of performEach(client, lines)) {
      assert.equal(result.status, "fulfilled");
      assert.equal(result.value.performance.words.map(({ text }) => text).join(" "), line.text);
      texts.push(line.text);
    }
    assert.deepEqual(texts, lines.map(({ text }) => text));
  });
});
