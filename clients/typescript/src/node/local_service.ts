/** Starts a service on this machine for a program of Node that wants one of its own, on a free port. */

import { spawn, type ChildProcess } from "node:child_process";
import { once } from "node:events";

const LISTENING = /listening on (http:\/\/\S+)/;

/** What is started and with which settings. */
export interface LocalServiceOptions {
  /** The program and its first arguments: `["understudy"]`, or `["python", "-m", "understudy.cli"]`. */
  readonly command: readonly [string, ...string[]];
  /** Settings of the service, besides the environment of this process (docs/settings.md). */
  readonly settings?: Readonly<Record<string, string>>;
}

/** A service that runs. */
export interface LocalService {
  readonly baseUrl: string;
  /** Ends it; resolves when it has gone. */
  stop(): Promise<void>;
}

/** The service, when it listens. Rejects with what it said when it ends before. */
export async function startLocalService({ command, settings = {} }: LocalServiceOptions): Promise<LocalService> {
  const [program, ...first] = command;
  const child = spawn(program, [...first, "serve", "--port", "0"], {
    env: { ...process.env, ...settings },
    stdio: ["ignore", "ignore", "pipe"],
  });
  const baseUrl = await addressOf(child);
  const stop = async (): Promise<void> => {
    if (child.exitCode === null && child.signalCode === null) {
      child.kill("SIGTERM");
      await once(child, "exit");
    }
  };
  return { baseUrl, stop };
}

/** What the service says that it listens on. Its log is read on and dropped, so that it never waits for a reader. */
function addressOf(child: ChildProcess): Promise<string> {
  return new Promise((resolve, reject) => {
    let said = "";
    child.stderr?.setEncoding("utf8").on("data", (text: string) => {
      said = (said + text).slice(-4000);
      const found = LISTENING.exec(said);
      if (found?.[1] !== undefined) {
        resolve(found[1]);
      }
    });
    child.once("error", reject);
    child.once("exit", () => {
      reject(new Error(`the service ended: ${said.trim()}`));
    });
  });
}
