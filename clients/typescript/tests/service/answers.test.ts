import assert from "node:assert/strict";
import { test } from "node:test";

import { problemOf, retryAfterS, warningCodes } from "../../src/service/answers.js";
import { ServiceProblemError, UnexpectedAnswerError } from "../../src/service/errors.js";

test("Retry-After is a number of seconds or a date", () => {
  const nowMs = Date.UTC(2026, 0, 1);
  assert.equal(retryAfterS("7", nowMs), 7);
  assert.equal(retryAfterS("Thu, 01 Jan 2026 00:00:30 GMT", nowMs), 30);
  assert.equal(retryAfterS("Wed, 31 Dec 2025 00:00:00 GMT", nowMs), 0);
  assert.equal(retryAfterS("soon", nowMs), undefined);
  assert.equal(retryAfterS(null, nowMs), undefined);
});

test("a problem keeps its code, field, time to wait and request id", async () => {
  const body = JSON.stringify({ type: "x", title: "x", status: 422, code: "text_empty", detail: "no words", field: "text" });
  const headers = { "content-type": "application/problem+json", "retry-after": "2", "x-request-id": "abc" };
  const error = await problemOf(new Response(body, { status: 422, headers }));
  assert.ok(error instanceof ServiceProblemError);
  assert.deepEqual(
    [error.status, error.code, error.detail, error.field, error.retryAfterS, error.requestId, error.message],
    [422, "text_empty", "no words", "text", 2, "abc", "text_empty: no words"],
  );
});

test("what a proxy answers in HTML is no problem of the service", async () => {
  const error = await problemOf(new Response("<h1>Bad Gateway</h1>", { status: 502, headers: { "content-type": "text/html" } }));
  assert.ok(error instanceof UnexpectedAnswerError);
  assert.match(error.message, /502 with text\/html/);
});

test("warnings are the codes of the header", () => {
  assert.deepEqual(warningCodes(new Response("", { headers: { "understudy-warnings": "a_b, c" } })), ["a_b", "c"]);
  assert.deepEqual(warningCodes(new Response("")), []);
});
