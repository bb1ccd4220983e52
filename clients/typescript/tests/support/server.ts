/** A server that answers as a test says, for what the real service cannot be brought to do at will. */

import { once } from "node:events";
import { createServer, type IncomingMessage, type Server, type ServerResponse } from "node:http";
import type { AddressInfo } from "node:net";

/** What a request is answered; undefined breaks the connection. */
export interface Answered {
  readonly status: number;
  readonly type?: string;
  readonly headers?: Record<string, string>;
  readonly body?: unknown;
}

export interface TestServer {
  readonly baseUrl: string;
  /** The headers of each request so far. */
  readonly requests: readonly IncomingMessage["headers"][];
  stop(): void;
}

/** Answers the requests one after another, the last answer ever after. */
export async function answering(...answers: (Answered | undefined | "never")[]): Promise<TestServer> {
  const requests: IncomingMessage["headers"][] = [];
  const server: Server = createServer((request, response) => {
    const answer = answers[Math.min(requests.length, answers.length - 1)];
    requests.push(request.headers);
    request.resume().on("end", () => {
      give(answer, response);
    });
  });
  server.listen(0, "127.0.0.1");
  await once(server, "listening");
  const { port } = server.address() as AddressInfo;
  const stop = (): void => {
    server.close();
    server.closeAllConnections();
  };
  return { baseUrl: `http://127.0.0.1:${port}`, requests, stop };
}

function give(answer: Answered | undefined | "never", response: ServerResponse): void {
  if (answer === undefined) {
    response.destroy();
  } else if (answer !== "never") {
    const body = typeof answer.body === "string" ? answer.body : JSON.stringify(answer.body ?? {});
    response.writeHead(answer.status, { "content-type": answer.type ?? "application/json", ...answer.headers });
    response.end(body);
  }
}

/** A problem as the service tells it. */
export function problem(status: number, code: string, headers: Record<string, string> = {}): Answered {
  const body = { type: `urn:understudy:error:${code}`, title: "…", status, code, detail: "what would be right" };
  return { status, type: "application/problem+json", headers, body };
}
