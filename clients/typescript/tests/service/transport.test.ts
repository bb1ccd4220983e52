import assert from "node:assert/strict";
import { after, test } from "node:test";

import { UnderstudyClient, type ClientOptions } from "../../src/service/client.js";
import { ConnectionError, ServiceProblemError, TimeoutError, UnexpectedAnswerError } from "../../src/service/errors.js";
import { answering, problem, type Answered, type TestServer } from "../support/server.js";

const servers: TestServer[] = [];
after(() => {
  for (const server of servers) {
    server.stop();
  }
});

const retry = { retries: 2, firstPauseMs: 1, longestPauseMs: 2 };
const READY: Answered = { status: 200, body: { status: "ready" } };

async function asking(
  answers: (Answered | undefined | "never")[],
  options: Partial<ClientOptions> = {},
): Promise<{ client: UnderstudyClient; server: TestServer }> {
  const server = await answering(...answers);
  servers.push(server);
  return { client: new UnderstudyClient({ baseUrl: `${server.baseUrl}/`, retry, ...options }), server };
}

test("a full service is asked again with the same request id, until it answers", async () => {
  const full = problem(503, "service_full");
  const { client, server } = await asking([full, problem(429, "too_many_requests"), READY]);
  assert.deepEqual(await client.status(), { status: "ready" });
  assert.equal(server.requests.length, 3);
  assert.equal(new Set(server.requests.map((headers) => headers["x-request-id"])).size, 1);
});

test("it gives up after the attempts that the policy allows, with the service's own error", async () => {
  const { client, server } = await asking([problem(503, "service_full")]);
  await assert.rejects(client.status(), (error) => error instanceof ServiceProblemError && error.code === "service_full");
  assert.equal(server.requests.length, 1 + retry.retries);
});

test("a mistake is not sent again", async () => {
  const { client, server } = await asking([problem(422, "text_empty")]);
  await assert.rejects(client.findFunctions(""), ServiceProblemError);
  assert.equal(server.requests.length, 1);
});

test("Retry-After delays the next attempt", async () => {
  const { client } = await asking([problem(503, "service_full", { "retry-after": "1" }), READY]);
  const begunMs = performance.now();
  await client.status();
  assert.ok(performance.now() - begunMs >= 990);
});

test("a connection that breaks is made again, and told when it goes on breaking", async () => {
  const broken = await asking([undefined, READY]);
  assert.deepEqual(await broken.client.status(), { status: "ready" });
  const { client, server } = await asking([undefined]);
  await assert.rejects(client.status(), (error) => error instanceof ConnectionError && error.cause !== undefined);
  assert.equal(server.requests.length, 1 + retry.retries);
});

test("the time limit holds for the answer and for the pauses between attempts", async () => {
  for (const answer of ["never", problem(503, "service_full", { "retry-after": "60" })] as const) {
    const { client } = await asking([answer], { timeoutMs: 100 });
    await assert.rejects(client.status(), TimeoutError);
  }
});

test("an aborted call rejects with the caller's reason, while it waits for an answer or between attempts", async () => {
  for (const answer of ["never", problem(503, "service_full", { "retry-after": "60" })] as const) {
    const { client } = await asking([answer]);
    const reason = new Error("the player walked away");
    const stopping = new AbortController();
    setTimeout(() => {
      stopping.abort(reason);
    }, 50);
    await assert.rejects(client.status({ signal: stopping.signal }), (error) => error === reason);
  }
});

test("a call that was aborted before it began asks nothing", async () => {
  const { client, server } = await asking([READY]);
  const reason = new Error("too late");
  await assert.rejects(client.status({ signal: AbortSignal.abort(reason) }), (error) => error === reason);
  assert.equal(server.requests.length, 0);
});

test("the key is sent as a bearer token, and a path before the service's is kept", async () => {
  const { client, server } = await asking([READY], { apiKey: "a-key-of-sixteen-letters" });
  await client.status();
  assert.equal(server.requests[0]?.authorization, "Bearer a-key-of-sixteen-letters");
});

test("what is not the service's answer is told so", async () => {
  const html = await asking([{ status: 200, type: "text/html", body: "<p>Sign in</p>" }]);
  await assert.rejects(html.client.status(), UnexpectedAnswerError);
  const cut = await asking([{ status: 200, body: '{"status":' }]);
  await assert.rejects(cut.client.status(), UnexpectedAnswerError);
});
