/** What a live stream was told and not read yet. */

import type { LiveReceived } from "./messages.js";

/** Messages in their order, whether they are waited for or come before; undefined once the connection is closed. */
export class Inbox {
  doneS: number | undefined;
  readonly #told: (LiveReceived | undefined)[] = [];
  #waiting: ((told: LiveReceived | undefined) => void) | undefined;
  #closed = false;

  constructor(socket: WebSocket) {
    socket.addEventListener("message", ({ data }) => { this.#put(JSON.parse(String(data)) as LiveReceived); });
    socket.addEventListener("close", () => {
      this.#closed = true;
      this.#put(undefined);
    });
  }

  next(): Promise<LiveReceived | undefined> {
    if (this.#told.length > 0 || this.#closed) {
      return Promise.resolve(this.#told.shift());
    }
    return new Promise((resolve) => { this.#waiting = resolve; });
  }

  #put(told: LiveReceived | undefined): void {
    if (told?.type === "done") {
      this.doneS = told.duration_s;
    }
    const waiting = this.#waiting;
    this.#waiting = undefined;
    if (waiting) {
      waiting(told);
    } else {
      this.#told.push(told);
    }
  }
}
