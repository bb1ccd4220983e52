/** Hooks of node's module loader: names are looked up in the page's import map, and its files are modules. */

import { readFileSync } from "node:fs";

const PAGE = new URL("../../../app/studio/page/", import.meta.url);
const INDEX = readFileSync(new URL("index.html", PAGE), "utf8");
const MAP = JSON.parse(/<script type="importmap">(.*?)<\/script>/s.exec(INDEX)?.[1] ?? "{}");

/**
 * @param {string} name
 * @param {object} context
 * @param {(name: string, context: object) => Promise<{ url: string }>} next
 */
export async function resolve(name, context, next) {
  const mapped = MAP.imports[name];
  const found = await next(mapped ? new URL(mapped.replace("./studio/", ""), PAGE).href : name, context);
  return found.url.startsWith(PAGE.href) ? { ...found, format: "module" } : found;
}
