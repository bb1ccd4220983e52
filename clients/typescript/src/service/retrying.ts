/**
 * When a request is made again, and after how long.
 *
 * Requests of the service have no effects, so any may be sent twice. It is, when the service is full (429, 503) or no
 * answer came. The pause doubles with each attempt and is drawn between half of that and all of it, so that callers
 * who were refused together do not come back together; it is never shorter than `Retry-After` asks.
 */

import { ConnectionError, ServiceProblemError } from "./errors.js";

const RETRIED_STATUSES = new Set([429, 503]);

/** How often and how slowly a request is made again. */
export interface RetryPolicy {
  /** Attempts after the first; 0 for none. */
  readonly retries: number;
  readonly firstPauseMs: number;
  readonly longestPauseMs: number;
}

export const DEFAULT_POLICY: RetryPolicy = { retries: 4, firstPauseMs: 250, longestPauseMs: 8000 };

/** What `attempt` brings, which is made again as the policy says. Rejects with the last error, or the signal's reason. */
export async function retried<Result>(
  attempt: () => Promise<Result>,
  policy: RetryPolicy,
  signal: AbortSignal,
): Promise<Result> {
  for (let made = 0; ; made++) {
    try {
      return await attempt();
    } catch (error) {
      if (made >= policy.retries || !isWorthRetrying(error)) {
        throw error;
      }
      await pause(pauseMs(error, made, policy), signal);
    }
  }
}

/** Whether the same request may succeed later. */
export function isWorthRetrying(error: unknown): boolean {
  const isFull = error instanceof ServiceProblemError && RETRIED_STATUSES.has(error.status);
  return isFull || error instanceof ConnectionError;
}

/** Milliseconds to wait after attempt number `made`, counted from 0. `draw` is in [0, 1). */
export function pauseMs(error: unknown, made: number, policy: RetryPolicy, draw = Math.random()): number {
  const wholeMs = Math.min(policy.firstPauseMs * 2 ** made, policy.longestPauseMs);
  const askedS = error instanceof ServiceProblemError ? (error.retryAfterS ?? 0) : 0;
  return Math.max(wholeMs * (0.5 + draw / 2), askedS * 1000);
}

function pause(durationMs: number, signal: AbortSignal): Promise<void> {
  return new Promise((resolve, reject) => {
    const stop = (): void => {
      clearTimeout(timer);
      // The reason is whatever the caller gave to abort().
      // eslint-disable-next-line @typescript-eslint/prefer-promise-reject-errors
      reject(signal.reason);
    };
    const timer = setTimeout(() => {
      signal.removeEventListener("abort", stop);
      resolve();
    }, durationMs);
    if (signal.aborted) {
      stop();
    }
    signal.addEventListener("abort", stop, { once: true });
  });
}
