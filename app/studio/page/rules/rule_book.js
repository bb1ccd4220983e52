/** The rules, words and movements of the service, what the author has made of their files, and what was said of that. */

import { lexiconFiles, readFile } from "../service/files.js";
import { problemOf } from "../service/service.js";
import { PROBLEM } from "../state/performed.js";
import { slice } from "../state/slice.js";

/** @import { PlacedMistake, RuleComparison, RuleExplanations, RuleFiles, Rules } from "understudy-client" */
/** @import { Service } from "../service/service.js" */
/** @import { Store } from "../state/store.js" */

/** @typedef {Rules["rules"][number]} Rule */
/** A rule, a word, a movement, or a whole file. @typedef {Omit<Rule, "kind"> & { kind: Rule["kind"] | "file" }} Item */

export const ITEMS = slice(/** @type {readonly Item[]} */ ([]));

/** The item that is looked at. */
export const CHOSEN = slice(/** @type {Item | null} */ (null));

/** What it is, rests on and leads to. */
export const EXPLAINED = slice(/** @type {RuleExplanations | null} */ (null));

export const FILES = slice(/** @type {RuleFiles} */ ({ files: [], saved: [], writable: false }));

/** Files that are no rules or words, and are edited as texts: characters, profiles, weights. */
export const OTHERS = slice(/** @type {RuleFiles} */ ({ files: [], saved: [], writable: false }));

/** The texts of files as they are in use, by their names. */
export const IN_USE = slice(/** @type {Readonly<Record<string, string>>} */ ({}));

/** The texts that the author has made others of. */
export const DRAFTS = slice(/** @type {Readonly<Record<string, string>>} */ ({}));

/** The mistakes in the rules with these texts. */
export const MISTAKES = slice(/** @type {readonly PlacedMistake[]} */ ([]));

/** Whether that is being asked. */
export const TRYING = slice(false);

/** What the texts change in all example lines and in the line; null until it was asked. */
export const COMPARED = slice(/** @type {RuleComparison | null} */ (null));

/**
 * @param {Store} store
 * @param {Service} service
 */
export async function loadBook(store, service) {
  await told(store, async () => {
    const [{ rules }, words, files, others] = await Promise.all([
      service.client.listRules(),
      service.fetch("lexicon").then((answer) => answer.json()),
      service.fetch("rules/files").then((answer) => answer.json()),
      lexiconFiles(service),
    ]);
    const texts = others.files.filter((name) => !name.endsWith(".gesture") && !files.files.includes(name));
    store.set(FILES, /** @type {RuleFiles} */ (files));
    store.set(OTHERS, { ...others, files: texts });
    store.set(ITEMS, [...rules, .../** @type {Rules} */ (words).rules, ...texts.map(itemOf)]);
    await Promise.all(store.get(FILES).saved.map((name) => loadText(store, service, name)));
  });
}

/**
 * A file as something to choose.
 *
 * @param {string} file as `lexicon/characters/reserved.yaml`
 * @returns {Item}
 */
export function itemOf(file) {
  const name = file.split("/").at(-1) ?? file;
  return { kind: "file", name: name.replace(/\.\w+$/, ""), file, line: 1 };
}

/**
 * Where a file is read and saved.
 *
 * @param {Store} store
 * @param {string} name
 */
export function pathOf(store, name) {
  return `${store.get(OTHERS).files.includes(name) ? "lexicon" : "rules"}/files/${name}`;
}

/**
 * Drafts of rules and words alone: what a line can be performed by.
 *
 * @param {Store} store
 */
export function ruleDrafts(store) {
  const others = store.get(OTHERS).files;
  return Object.fromEntries(Object.entries(store.get(DRAFTS)).filter(([name]) => !others.includes(name)));
}

/**
 * The text of a file, from the service if it was not asked for before; one that the author had saved is his draft.
 *
 * @param {Store} store
 * @param {Service} service
 * @param {string} name
 */
export async function loadText(store, service, name) {
  if (name in store.get(IN_USE)) {
    return;
  }
  await told(store, async () => {
    const { text, saved } = await readFile(service, pathOf(store, name));
    store.patch(IN_USE, { [name]: text });
    if (saved) {
      store.patch(DRAFTS, { [name]: text });
    }
  });
}

/**
 * @param {Store} store
 * @param {Service} service
 * @param {Item} item
 */
export async function explain(store, service, item) {
  if (item.kind === "file") {
    store.set(EXPLAINED, null);
    return;
  }
  await told(store, async () => {
    const found = await posted(service, "rules/explain", { name: item.name });
    if (store.get(CHOSEN) === item) {
      store.set(EXPLAINED, /** @type {RuleExplanations} */ (found));
    }
  });
}

/**
 * @param {Service} service
 * @param {string} path
 * @param {object} content
 */
export async function posted(service, path, content) {
  const request = { method: "POST", headers: { "content-type": "application/json" }, body: JSON.stringify(content) };
  return /** @type {unknown} */ (await (await service.fetch(path, request)).json());
}

/**
 * Does it, and tells what was refused.
 *
 * @param {Store} store
 * @param {() => Promise<void>} work
 */
export async function told(store, work) {
  try {
    await work();
  } catch (error) {
    store.set(PROBLEM, problemOf(error));
  }
}
