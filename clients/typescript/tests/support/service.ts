/** The real service, which a test file starts for itself, and the recordings of the repository. */

import { existsSync } from "node:fs";
import { readFile } from "node:fs/promises";
import { fileURLToPath } from "node:url";

import { startLocalService, type LocalService } from "../../src/node/local_service.js";

const REPOSITORY = new URL("../../../../../", import.meta.url);
const PYTHON = process.env["UNDERSTUDY_PYTHON"] ?? fileURLToPath(new URL(".venv/bin/python", REPOSITORY));

/** Why tests with the service cannot run, for node:test's `skip`; false where they can. */
export const noService: string | false = existsSync(PYTHON) ? false : "understudy is not installed: run make perform";

/** One worker, so that tests leave processors to others. */
export function startService(settings: Record<string, string> = {}): Promise<LocalService> {
  const command = [PYTHON, "-m", "understudy.cli"] as const;
  return startLocalService({ command, settings: { UNDERSTUDY_WORKERS: "1", OMP_NUM_THREADS: "1", ...settings } });
}

/** A recording of tests/audio and its words. */
export async function recorded(name: string): Promise<{ audio: Uint8Array<ArrayBuffer>; text: string }> {
  const folder = new URL("tests/audio/", REPOSITORY);
  const audio = await readFile(new URL(`${name}.flac`, folder));
  return { audio: new Uint8Array(audio), text: (await readFile(new URL(`${name}.txt`, folder), "utf8")).trim() };
}
