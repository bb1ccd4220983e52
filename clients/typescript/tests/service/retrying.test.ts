import assert from "node:assert/strict";
import { test } from "node:test";

import { ConnectionError, ServiceProblemError } from "../../src/service/errors.js";
import { DEFAULT_POLICY, isWorthRetrying, pauseMs } from "../../src/service/retrying.js";

function problem(status: number, retryAfterS?: number): ServiceProblemError {
  const told = { type: "x", title: "x", status, code: "service_full", detail: "x" } as const;
  return new ServiceProblemError(told, retryAfterS);
}

test("a full service and a broken connection are worth another attempt, mistakes and deadlines are not", () => {
  const worth = [problem(429), problem(503), new ConnectionError("x")].map(isWorthRetrying);
  assert.deepEqual(worth, [true, true, true]);
  assert.deepEqual([problem(422), problem(500), problem(504), new Error("x")].map(isWorthRetrying), [false, false, false, false]);
});

test("pauses double up to the longest, and are drawn between half and all of it", () => {
  const policy = { retries: 9, firstPauseMs: 100, longestPauseMs: 500 };
  const longest = [0, 1, 2, 3, 4].map((made) => pauseMs(problem(503), made, policy, 1));
  assert.deepEqual(longest, [100, 200, 400, 500, 500]);
  assert.equal(pauseMs(problem(503), 1, policy, 0), 100);
});

test("Retry-After is waited for in full", () => {
  assert.equal(pauseMs(problem(503, 3), 0, DEFAULT_POLICY, 0), 3000);
  assert.equal(pauseMs(problem(503, 0), 0, DEFAULT_POLICY, 1), DEFAULT_POLICY.firstPauseMs);
});
