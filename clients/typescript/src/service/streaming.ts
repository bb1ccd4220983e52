/** Many lines, performed a few at a time, in the order in which they were given. */

import type { UnderstudyClient } from "./client.js";
import type { CallOptions, Performed, PerformRequest } from "./types.js";

/** How many lines are performed. */
export interface StreamOptions extends CallOptions {
  /** Lines under way at once; 2 unless given. More than the service has workers only wait. */
  readonly concurrency?: number;
}

/** What became of a line: its performance, or why there is none. One that fails does not end the others. */
export interface PerformedLine<Line extends PerformRequest = PerformRequest> {
  readonly line: Line;
  readonly result: PromiseSettledResult<Performed>;
}

/**
 * Performs each line; yields them in order, each as soon as it and those before it are done. No more lines are taken
 * than are under way, so that `lines` may be endless, and what reads the stream sets its pace.
 */
export async function* performEach<Line extends PerformRequest>(
  client: Pick<UnderstudyClient, "perform">,
  lines: Iterable<Line> | AsyncIterable<Line>,
  { concurrency = 2, ...call }: StreamOptions = {},
): AsyncGenerator<PerformedLine<Line>, void, undefined> {
  const underWay: Promise<PerformedLine<Line>>[] = [];
  for await (const line of lines) {
    const settled = Promise.allSettled([client.perform(line, call)]);
    underWay.push(settled.then(([result]) => ({ line, result })));
    const first = underWay.length >= concurrency ? underWay.shift() : undefined;
    if (first) {
      yield await first;
    }
  }
  for (const rest of underWay) {
    yield await rest;
  }
}
