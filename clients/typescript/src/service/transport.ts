/** One call of the service: address, key, request id, time limit, attempts, errors. */

import { problemOf, requireType } from "./answers.js";
import { ConnectionError, TimeoutError, UnderstudyError, UnexpectedAnswerError } from "./errors.js";
import { retried, type RetryPolicy } from "./retrying.js";
import type { CallOptions } from "./types.js";

/** Where the service is, and how it is called. */
export interface Transport {
  readonly baseUrl: string;
  readonly apiKey: string | undefined;
  readonly timeoutMs: number;
  readonly policy: RetryPolicy;
  readonly fetch: typeof fetch;
}

/** What is asked. `body` is made anew for each attempt; without one the method is GET. */
export interface Call {
  readonly path: string;
  readonly accept: string;
  readonly body?: () => FormData | string;
}

/** What `read` makes of a successful answer. Rejects with an UnderstudyError, or the reason of the caller's signal. */
export async function called<Result>(
  transport: Transport,
  call: Call,
  read: (answer: Response) => Promise<Result>,
  { signal, timeoutMs = transport.timeoutMs }: CallOptions = {},
): Promise<Result> {
  const late = AbortSignal.timeout(timeoutMs);
  const stopped = signal ? AbortSignal.any([signal, late]) : late;
  // One id for all attempts, so that they are found together in the service's log.
  const requestId = crypto.randomUUID();
  const attempt = async (): Promise<Result> => {
    const answer = await transport.fetch(transport.baseUrl + call.path, request(transport, call, requestId, stopped));
    if (!answer.ok) {
      throw await problemOf(answer);
    }
    requireType(answer, call.accept);
    return await read(answer);
  };
  try {
    return await retried(() => attempt().catch((error: unknown) => told(error, stopped)), transport.policy, stopped);
  } catch (error) {
    throw error === late.reason && late.aborted ? new TimeoutError(timeoutMs) : error;
  }
}

function request(transport: Transport, call: Call, requestId: string, signal: AbortSignal): RequestInit {
  const headers: Record<string, string> = { accept: call.accept, "x-request-id": requestId };
  if (transport.apiKey !== undefined) {
    headers["authorization"] = `Bearer ${transport.apiKey}`;
  }
  const body = call.body?.();
  if (typeof body === "string") {
    headers["content-type"] = "application/json";
  }
  return body === undefined ? { headers, signal } : { method: "POST", headers, body, signal };
}

/** Throws what `fetch` threw in the words of this package; what it throws when stopped is the signal's reason. */
function told(error: unknown, stopped: AbortSignal): never {
  if (stopped.aborted) {
    throw stopped.reason;
  }
  if (error instanceof SyntaxError) {
    throw new UnexpectedAnswerError("the answer is not the JSON that it says it is", { cause: error });
  }
  throw error instanceof UnderstudyError ? error : new ConnectionError("the service did not answer", { cause: error });
}
