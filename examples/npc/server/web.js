/** The game's pages and answers over HTTP. Everything comes from this machine. */

import { readFile } from "node:fs/promises";
import { createServer } from "node:http";
import { extname, join, normalize, sep } from "node:path";
import { fileURLToPath } from "node:url";
import { UnderstudyError } from "understudy-client";

/** @import { Server, ServerResponse } from "node:http" */
/** @import { Dialogue } from "./dialogue.js" */
/** @import { Performances } from "./performances.js" */

/** @type {Readonly<Record<string, string>>} */
const TYPES = {
  ".html": "text/html; charset=utf-8",
  ".css": "text/css",
  ".js": "text/javascript",
  ".json": "application/json",
  ".flac": "audio/flac",
  ".glb": "model/gltf-binary",
};

const ROOT = new URL("../", import.meta.url);

/** Folders whose files are served, by the beginning of their paths. */
const FOLDERS = Object.entries({
  "/page/": fileURLToPath(new URL("page/", ROOT)),
  "/lines/": fileURLToPath(new URL("lines/", ROOT)),
  "/three/addons/": fileURLToPath(new URL("node_modules/three/examples/jsm/", ROOT)),
  "/three/": fileURLToPath(new URL("node_modules/three/build/", ROOT)),
  "/client/": fileURLToPath(new URL("node_modules/understudy-client/dist/src/", ROOT)),
});

/**
 * The server, which does not listen yet.
 *
 * @param {Dialogue} dialogue
 * @param {Performances} performances
 * @returns {Server}
 */
export function gameServer(dialogue, performances) {
  return createServer((request, response) => {
    const path = request.url === "/" ? "/page/index.html" : (request.url ?? "").replace(/\?.*/, "");
    answered(path, dialogue, performances).then(
      (content) => give(response, content ? 200 : 404, extname(path), content ?? "not found"),
      (error) => giveError(response, error),
    );
  });
}

/**
 * @param {string} path
 * @param {Dialogue} dialogue
 * @param {Performances} performances
 * @returns {Promise<Uint8Array | string | undefined>}
 */
async function answered(path, dialogue, performances) {
  const [, room, name = ""] = /^\/(\w+)\/(\w+)\.\w+$/.exec(path) ?? [];
  const npc = name === "speaker" || name === "listener" ? dialogue[name] : undefined;
  const line = dialogue.lines.find(({ id }) => id === name);
  if (path === "/dialogue.json") {
    return JSON.stringify(dialogue);
  }
  if (room === "bodies" && npc) {
    return performances.body(npc);
  }
  if (room === "idles" && npc) {
    return performances.idle(npc);
  }
  return room === "performances" && line ? performances.line(line) : file(path);
}

/**
 * A file of one of the folders; undefined where there is none.
 *
 * @param {string} path
 */
async function file(path) {
  const [start, folder] = FOLDERS.find(([beginning]) => path.startsWith(beginning)) ?? [];
  if (start === undefined || folder === undefined || !(extname(path) in TYPES)) {
    return undefined;
  }
  const found = normalize(join(folder, path.slice(start.length)));
  return found.startsWith(folder.endsWith(sep) ? folder : folder + sep)
    ? readFile(found).catch(() => undefined)
    : undefined;
}

/**
 * @param {ServerResponse} response
 * @param {unknown} error
 */
function giveError(response, error) {
  const isOfService = error instanceof UnderstudyError;
  console.error(isOfService ? error.message : error);
  give(response, isOfService ? 502 : 500, ".json", JSON.stringify({ detail: isOfService ? error.message : "a fault" }));
}

/**
 * @param {ServerResponse} response
 * @param {number} status
 * @param {string} extension
 * @param {Uint8Array | string} content
 */
function give(response, status, extension, content) {
  response.writeHead(status, { "content-type": TYPES[extension] ?? "text/plain" });
  response.end(content);
}
