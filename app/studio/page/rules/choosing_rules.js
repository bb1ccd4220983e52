/** Which rules and words a filter finds, and in which groups they are. */

import { functionName } from "../naming/meanings.js";

/** @import { Item } from "./rule_book.js" */

export const MOST_SHOWN = 200;

/**
 * The items of a kind (any, if it is empty) in which every word of the filter occurs: in the name, the class, the
 * subtype or the file. Those whose name begins with the filter come first.
 *
 * @param {readonly Item[]} items
 * @param {string} filter
 * @param {string} kind
 * @returns {Item[]}
 */
export function matching(items, filter, kind) {
  const words = filter.toLowerCase().split(/\s+/).filter(Boolean);
  const found = items.filter((item) => (!kind || item.kind === kind) && words.every((word) => textOf(item).includes(word)));
  const begins = (/** @type {Item} */ { name }) => Number(!name.toLowerCase().startsWith(filter.trim().toLowerCase()));
  return words.length > 0 ? found.sort((one, other) => begins(one) - begins(other)) : found;
}

/**
 * Items by what they are about: the function that they are of, else their file. In alphabetical order.
 *
 * @param {readonly Item[]} items
 * @returns {{ name: string, items: Item[] }[]}
 */
export function groupsOf(items) {
  /** @type {Map<string, Item[]>} */
  const groups = new Map();
  for (const item of items) {
    const name = groupOf(item);
    groups.set(name, [...(groups.get(name) ?? []), item]);
  }
  return [...groups].map(([name, found]) => ({ name, items: found })).sort((one, other) => one.name.localeCompare(other.name));
}

/** @param {Item} item */
function groupOf({ kind, class: of, file }) {
  if (kind === "file") {
    return file.endsWith("/weights.yaml") ? "weights" : (file.split("/").at(-2) ?? file);
  }
  if (of?.includes("|")) {
    return "several meanings";
  }
  const found = of && !of.includes("$") ? functionName({ class: of }) : fileName(file);
  return found.replace(/^(an?|the) /, "");
}

/** @param {string} file */
function fileName(file) {
  const own = (file.split("/").at(-1) ?? file).replace(/\.\w+$/, "").replaceAll("_", " ");
  return own === "behaviors" ? "movements" : own;
}

/** @param {Item} item */
function textOf(item) {
  return [item.name, item.class, item.subtype, item.file].join(" ").toLowerCase();
}
