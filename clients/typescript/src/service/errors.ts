/** What a call can end in, besides the reason of its own AbortSignal. */

import type { Problem } from "./types.js";

/** Any of the errors below. */
export abstract class UnderstudyError extends Error {}

/** The service refused, and says why: `code` is stable (docs/errors.md), `field` names the part of the request. */
export class ServiceProblemError extends UnderstudyError {
  override readonly name = "ServiceProblemError";
  readonly status: number;
  readonly code: string;
  readonly detail: string;
  readonly field: string | undefined;
  /** Seconds after which the service asks to be tried again. */
  readonly retryAfterS: number | undefined;
  /** The id of the request in the service's log. */
  readonly requestId: string | undefined;

  constructor(problem: Problem, retryAfterS?: number, requestId?: string) {
    super(`${problem.code}: ${problem.detail}`);
    this.status = problem.status;
    this.code = problem.code;
    this.detail = problem.detail;
    this.field = problem.field ?? undefined;
    this.retryAfterS = retryAfterS;
    this.requestId = requestId;
  }
}

/** No answer came: no connection, or one that broke. `cause` is what fetch said. */
export class ConnectionError extends UnderstudyError {
  override readonly name = "ConnectionError";
}

/** The call took longer than its `timeoutMs`, all attempts together. */
export class TimeoutError extends UnderstudyError {
  override readonly name = "TimeoutError";

  constructor(timeoutMs: number) {
    super(`no answer within ${timeoutMs} ms`);
  }
}

/** What was answered is not what the service answers; something between may have. */
export class UnexpectedAnswerError extends UnderstudyError {
  override readonly name = "UnexpectedAnswerError";
}
