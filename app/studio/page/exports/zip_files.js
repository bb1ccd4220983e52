/** Zip files that people open: what they say that they unpack to is limited before anything is unpacked. */

import { unzipSync } from "fflate";

const LARGEST_MB = 1024;

/**
 * The files in a zip, by path. Throws where it is none, or unpacks to more than the page can hold.
 *
 * @param {string} name of the zip
 * @param {Uint8Array} content
 * @param {number} [largestMb]
 * @returns {Record<string, Uint8Array>}
 */
export function unzipped(name, content, largestMb = LARGEST_MB) {
  if (unpackedBytes(name, content) > largestMb * 2 ** 20) {
    throw new Error(`${name} unpacks to more than ${String(largestMb)} MB; take a part of it`);
  }
  return opened(name, () => unzipSync(content));
}

/**
 * What the zip's directory says of the sizes of its files; each is unpacked into so many bytes and no more.
 *
 * @param {string} name
 * @param {Uint8Array} content
 */
function unpackedBytes(name, content) {
  let bytes = 0;
  const filter = (/** @type {{ originalSize: number }} */ file) => {
    bytes += file.originalSize;
    return false;
  };
  opened(name, () => unzipSync(content, { filter }));
  return bytes;
}

/**
 * @param {string} name
 * @param {() => Record<string, Uint8Array>} open
 */
function opened(name, open) {
  try {
    return open();
  } catch (error) {
    throw new Error(`${name} is not a zip that can be opened`, { cause: error });
  }
}
