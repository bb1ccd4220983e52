/**
 * Speech in, movements out, as it goes on (docs/live.md): one stream of `WS /live`. Sound is sent as it comes, messages
 * are read by `for await` until the stream is done; both sides may go at the same time.
 */

import { ConnectionError, ServiceProblemError, UnexpectedAnswerError } from "../service/errors.js";
import { Inbox } from "./inbox.js";
import type { LiveCommand, LiveError, LiveMessage, LiveReady, LiveStart, LiveWords } from "./messages.js";

/** Where the service is. */
export interface LiveAddress {
  /** As for UnderstudyClient: `http://127.0.0.1:8000`. */
  readonly baseUrl: string;
  readonly apiKey?: string | undefined;
  /** In place of the global `WebSocket`, which Node has from 22 on: that of the package `ws`, for instance. */
  readonly WebSocket?: new (address: string, protocols: string[]) => WebSocket;
}

/** A stream that has begun. It is read once, by `for await`; leaving the loop closes it. */
export class LiveStream implements AsyncIterable<LiveMessage> {
  readonly ready: LiveReady;
  /** Seconds that were heard, once the stream is done. */
  duration_s: number | undefined;
  readonly #socket: WebSocket;
  readonly #inbox: Inbox;

  private constructor(socket: WebSocket, inbox: Inbox, ready: LiveReady) {
    this.#socket = socket;
    this.#inbox = inbox;
    this.ready = ready;
  }

  /** Begins a stream. Rejects with ServiceProblemError where the service refuses, ConnectionError where none answers. */
  static async open(address: LiveAddress, start: LiveStart = {}): Promise<LiveStream> {
    const Socket = address.WebSocket ?? globalThis.WebSocket;
    const socket = new Socket(`${address.baseUrl.replace(/^http/, "ws").replace(/\/+$/, "")}/live`, protocols(address.apiKey));
    const inbox = new Inbox(socket);
    await new Promise((resolve, reject) => {
      socket.addEventListener("open", resolve, { once: true });
      socket.addEventListener("error", () => { reject(new ConnectionError("the service did not answer")); }, { once: true });
    });
    socket.send(JSON.stringify({ type: "start", ...start }));
    const first = await inbox.next();
    if (first?.type !== "ready") {
      socket.close();
      throw first?.type === "error" ? problem(first) : new UnexpectedAnswerError("the stream did not begin");
    }
    return new LiveStream(socket, inbox, first);
  }

  /** Sends samples: 16 bits, or -1 to 1 as the Web Audio API has them; of two channels one after the other. */
  send(samples: Int16Array | Float32Array): void {
    this.#socket.send(littleEndian(samples));
  }

  /** Says what the character says. */
  sendWords(words: LiveWords): void {
    this.#command({ type: "words", ...words });
  }

  /** Nothing was heard for so long: chunks were lost, or the microphone is off. */
  sendSilence(durationS: number): void {
    this.#command({ type: "silence", duration_s: durationS });
  }

  /** From now on the samples are those of whom the character listens to; `speak` has it speak again. */
  listen(): void {
    this.#command({ type: "listen" });
  }

  speak(): void {
    this.#command({ type: "speak" });
  }

  /** What goes on stops now. */
  interrupt(): void {
    this.#command({ type: "interrupt" });
  }

  /** The sound is over; what is still told is read until the loop ends. */
  end(): void {
    this.#command({ type: "end" });
  }

  /** Breaks off at once. */
  close(): void {
    this.#socket.close();
  }

  async *[Symbol.asyncIterator](): AsyncGenerator<LiveMessage, void, undefined> {
    try {
      for (let told = await this.#inbox.next(); told?.type !== "done"; told = await this.#inbox.next()) {
        if (told === undefined) {
          throw new ConnectionError("the stream broke off");
        }
        if (told.type === "error" && !told.goes_on) {
          throw problem(told);
        }
        if (told.type !== "ready") {
          yield told;
        }
      }
      this.duration_s = this.#inbox.doneS;
    } finally {
      this.close();
    }
  }

  #command(message: LiveCommand): void {
    this.#socket.send(JSON.stringify(message));
  }
}

/** A key is offered as a protocol, for browsers give a WebSocket no headers. */
function protocols(apiKey: string | undefined): string[] {
  if (apiKey === undefined) {
    return [];
  }
  const coded = btoa(String.fromCharCode(...new TextEncoder().encode(apiKey)));
  return ["understudy", `understudy.key.${coded.replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "")}`];
}

function littleEndian(samples: Int16Array | Float32Array): ArrayBuffer {
  const written = new DataView(new ArrayBuffer(2 * samples.length));
  samples.forEach((sample, index) => {
    const value = samples instanceof Float32Array ? Math.round(32767 * Math.min(1, Math.max(-1, sample))) : sample;
    written.setInt16(2 * index, value, true);
  });
  return written.buffer;
}

function problem({ code, detail, field }: LiveError): ServiceProblemError {
  return new ServiceProblemError({ type: "about:blank", title: "Live stream", status: 400, code, detail, field: field ?? null });
}
