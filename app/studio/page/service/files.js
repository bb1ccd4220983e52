/**
 * The files that authors write: read, and saved into their folder (`--lexicon DIR`) where the service has one. What somebody
 * else saved meanwhile is never overwritten: the service tells the version that was read from any other (ETag).
 */

/** @import { RuleFile, RuleFiles } from "understudy-client" */
/** @import { Service } from "./service.js" */

/** The version that was read or saved last, by path. @type {WeakMap<Service, Map<string, string>>} */
const VERSIONS = new WeakMap();

/**
 * The gestures, characters, profiles and weights; `writable` says whether files can be saved.
 *
 * @param {Service} service
 */
export async function lexiconFiles(service) {
  return /** @type {RuleFiles} */ (await (await service.fetch("lexicon/files")).json());
}

/**
 * A file; one that may be made anew is empty. Rejects where the service has none of that name.
 *
 * @param {Service} service
 * @param {string} path from the service on, as `lexicon/files/lexicon/gestures/own.gesture`
 */
export async function readFile(service, path) {
  const answer = await service.fetch(path);
  keepVersion(service, path, answer);
  return /** @type {RuleFile} */ (await answer.json());
}

/**
 * Saves a file. Rejects where it has mistakes, or was changed since it was read.
 *
 * @param {Service} service
 * @param {string} path
 * @param {string} text
 */
export async function saveFile(service, path, text) {
  const version = VERSIONS.get(service)?.get(path);
  const headers = new Headers({ "content-type": "text/plain" });
  if (version) {
    headers.set("if-match", version);
  }
  const answer = await service.fetch(path, { method: "PUT", headers, body: text });
  keepVersion(service, path, answer);
}

/**
 * @param {Service} service
 * @param {string} path
 * @param {Response} answer
 */
function keepVersion(service, path, answer) {
  const versions = VERSIONS.get(service) ?? new Map();
  VERSIONS.set(service, versions.set(path, answer.headers.get("etag") ?? ""));
}
