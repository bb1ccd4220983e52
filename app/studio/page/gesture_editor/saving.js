/** Gestures as files: saved into the author's folder where the service has one, else taken away as a file. */

import { el } from "../dom.js";
import { lexiconFiles, readFile, saveFile } from "../service/files.js";
import { problemOf } from "../service/service.js";
import { PROBLEM } from "../state/performed.js";
import { slice } from "../state/slice.js";
import { textNow } from "./checking.js";
import { EDITED, gestureOf } from "./gestures.js";

/** @import { Gestures } from "understudy-client" */
/** @import { Service } from "../service/service.js" */
/** @import { Store } from "../state/store.js" */

/** Whether gestures are saved into a folder of the author's. */
export const IS_WRITABLE = slice(false);

/** What was saved, and where to; nothing before something was. */
export const SAVED = slice("");

/**
 * @param {Store} store
 * @param {Service} service
 */
export async function askWhereToSave(store, service) {
  await told(store, async () => store.set(IS_WRITABLE, (await lexiconFiles(service)).writable));
}

/**
 * Saves what is edited, as the file that its text is.
 *
 * @param {Store} store
 * @param {Service} service
 */
export async function save(store, service) {
  const text = await textNow(store, service);
  if (text === null) {
    return;
  }
  await told(store, async () => {
    const { name } = gestureOf(store.get(EDITED));
    const known = /** @type {Gestures} */ (await service.client.listGestures()).gestures.find((each) => each.name === name);
    const file = known?.file ?? `lexicon/gestures/${name}.gesture`;
    const path = `lexicon/files/${file}`;
    const before = await readFile(service, path);
    await saveFile(service, path, withGesture(before.text, name, text));
    store.set(SAVED, `${name} is saved in ${file}.`);
  });
}

/**
 * @param {Store} store
 * @param {Service} service
 */
export async function download(store, service) {
  const text = await textNow(store, service);
  if (text !== null) {
    const url = URL.createObjectURL(new Blob([text], { type: "text/plain" }));
    el("a", { href: url, download: `${gestureOf(store.get(EDITED)).name}.gesture` }).click();
    URL.revokeObjectURL(url);
  }
}

/**
 * The text of a file with a gesture in the place of the one of its name, else at its end. Comments above a gesture stay.
 *
 * @param {string} file
 * @param {string} name
 * @param {string} gesture
 */
export function withGesture(file, name, gesture) {
  const blocks = file.split(/^(?=GESTURECLASS\b)/m);
  const place = blocks.findIndex((block) => new RegExp(`^GESTUREINSTANCE\\s+${name}\\s*$`, "m").test(block));
  const own = `${gesture.trim()}\n`;
  if (place < 0) {
    return [...(file.trim() ? [file.trimEnd(), ""] : []), own].join("\n");
  }
  const after = /\n((?:\s*#[^\n]*\n|\s*\n)*)$/.exec(blocks[place] ?? "")?.[1] ?? "";
  return blocks.map((block, at) => (at === place ? own + after : block)).join("");
}

/**
 * @param {Store} store
 * @param {() => Promise<unknown>} work
 */
async function told(store, work) {
  try {
    await work();
  } catch (error) {
    store.set(PROBLEM, problemOf(error));
  }
}
