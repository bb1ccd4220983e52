/** Tells an answer that is as asked from one that is a problem. */

import { ServiceProblemError, UnexpectedAnswerError, type UnderstudyError } from "./errors.js";
import type { Problem } from "./types.js";

const PROBLEM = "application/problem+json";

/** The error that an answer other than 200 tells. */
export async function problemOf(answer: Response): Promise<UnderstudyError> {
  const requestId = answer.headers.get("x-request-id") ?? undefined;
  if (mediaType(answer) !== PROBLEM) {
    return new UnexpectedAnswerError(`status ${answer.status} with ${mediaType(answer) || "no media type"}`);
  }
  const problem = (await answer.json()) as Problem;
  return new ServiceProblemError(problem, retryAfterS(answer.headers.get("retry-after"), Date.now()), requestId);
}

/** Fails where the answer is of another media type than was asked for. */
export function requireType(answer: Response, asked: string): void {
  if (mediaType(answer) !== asked) {
    throw new UnexpectedAnswerError(`asked for ${asked}, got ${mediaType(answer) || "no media type"}`);
  }
}

/** The codes of what was degraded, dropped or guessed. */
export function warningCodes(answer: Response): string[] {
  const codes = answer.headers.get("understudy-warnings") ?? "";
  return codes.split(",").map((code) => code.trim()).filter((code) => code !== "");
}

/** Seconds from `nowMs` that a Retry-After header asks to wait: its number, or until its date (RFC 9110 §10.2.3). */
export function retryAfterS(header: string | null, nowMs: number): number | undefined {
  if (header === null) {
    return undefined;
  }
  const seconds = /^\d+$/.test(header.trim()) ? Number(header) : (Date.parse(header) - nowMs) / 1000;
  return Number.isNaN(seconds) ? undefined : Math.max(0, seconds);
}

function mediaType(answer: Response): string {
  return (answer.headers.get("content-type") ?? "").split(";", 1)[0]?.trim().toLowerCase() ?? "";
}
