/** Puts the game together: a service, unless one is given, what is asked of it, and the web server. */

import { once } from "node:events";
import { fileURLToPath } from "node:url";
import { UnderstudyClient } from "understudy-client";
import { startLocalService } from "understudy-client/local-service";

import { Cache } from "./cache.js";
import { readDialogue } from "./dialogue.js";
import { Performances } from "./performances.js";
import { gameServer } from "./web.js";

/** @import { AddressInfo } from "node:net" */

/**
 * @typedef {object} GameOptions
 * @property {number} port 0 for any that is free
 * @property {string} cacheFolder
 * @property {string | undefined} serviceUrl a service that runs; one is started unless given
 * @property {string | undefined} apiKey
 * @property {readonly [string, ...string[]]} command what starts a service
 */

/** @param {NodeJS.ProcessEnv} environment */
export function optionsFrom(environment) {
  const python = environment["UNDERSTUDY_PYTHON"] ?? fileURLToPath(new URL("../../../.venv/bin/python", import.meta.url));
  return {
    port: Number(environment["PORT"] ?? 8080),
    cacheFolder: fileURLToPath(new URL("../.cache/", import.meta.url)),
    serviceUrl: environment["UNDERSTUDY_URL"],
    apiKey: environment["UNDERSTUDY_KEY"],
    command: /** @type {const} */ ([python, "-m", "understudy.cli"]),
  };
}

/**
 * The game, when players can come.
 *
 * @param {GameOptions} options
 * @returns {Promise<{ url: string, stop: () => Promise<void> }>}
 */
export async function startGame({ port, cacheFolder, serviceUrl, apiKey, command }) {
  const dialogue = await readDialogue();
  const service = serviceUrl === undefined ? await startLocalService({ command }) : undefined;
  const baseUrl = service?.baseUrl ?? serviceUrl ?? "";
  const client = new UnderstudyClient({ baseUrl, apiKey });
  const server = gameServer(dialogue, new Performances(client, new Cache(cacheFolder), dialogue));
  server.listen(port, "127.0.0.1");
  await once(server, "listening");
  const { port: own } = /** @type {AddressInfo} */ (server.address());
  const stop = async () => {
    server.close();
    server.closeAllConnections();
    await service?.stop();
  };
  return { url: `http://127.0.0.1:${own}/`, stop };
}
