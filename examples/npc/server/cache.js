/** Answers of the service that are kept on disk, by what was asked; what is being asked is asked once. */

import { createHash, randomUUID } from "node:crypto";
import { mkdir, readFile, rename, writeFile } from "node:fs/promises";
import { join } from "node:path";

/** Files in one folder, which may be deleted at any time. */
export class Cache {
  /** @type {string} */
  #folder;
  /** @type {Map<string, Promise<Uint8Array>>} */
  #underWay = new Map();

  /** @param {string} folder */
  constructor(folder) {
    this.#folder = folder;
  }

  /**
   * What was made of these parts before, or what `make` makes of them now.
   *
   * @param {(string | Uint8Array)[]} parts
   * @param {() => Promise<Uint8Array>} make
   * @returns {Promise<Uint8Array>}
   */
  async kept(parts, make) {
    const key = keyOf(parts);
    const underWay = this.#underWay.get(key);
    if (underWay) {
      return underWay;
    }
    const asking = this.#readOrMade(key, make).finally(() => this.#underWay.delete(key));
    this.#underWay.set(key, asking);
    return asking;
  }

  /**
   * @param {string} key
   * @param {() => Promise<Uint8Array>} make
   */
  async #readOrMade(key, make) {
    const path = join(this.#folder, key);
    try {
      return await readFile(path);
    } catch (error) {
      if (/** @type {NodeJS.ErrnoException} */ (error).code !== "ENOENT") {
        throw error;
      }
    }
    const content = await make();
    await mkdir(this.#folder, { recursive: true });
    const unfinished = `${path}.${randomUUID()}`;
    await writeFile(unfinished, content);
    await rename(unfinished, path);
    return content;
  }
}

/**
 * The name of the file for these parts: their SHA-256, each with its length before it.
 *
 * @param {(string | Uint8Array)[]} parts
 */
function keyOf(parts) {
  const hash = createHash("sha256");
  for (const part of parts) {
    hash.update(`${part.length} `).update(part);
  }
  return hash.digest("hex");
}
