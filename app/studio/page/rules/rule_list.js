/** The rule browser: everything that authors edit, filtered by words and kind. */

import { choice, el, labelled } from "../dom.js";
import { slice } from "../state/slice.js";
import { matching, MOST_SHOWN } from "./choosing_rules.js";
import { CHOSEN, ITEMS } from "./rule_book.js";

/** @import { Store } from "../state/store.js" */
/** @import { Item } from "./rule_book.js" */

const KINDS = /** @type {const} */ ([["", "everything"], ["function", "function rules"], ["behavior", "mapping rules"], ["bml", "movements"], ["word", "words"]]);

const FILTER = slice({ text: "", kind: "" });

/** @param {Store} store */
export function ruleList(store) {
  const typed = el("input", { id: "rule-filter", type: "search", autocomplete: "off", spellcheck: false });
  typed.addEventListener("input", () => store.patch(FILTER, { text: typed.value }));
  const kind = choice(KINDS, "", (value) => store.patch(FILTER, { kind: value }));
  kind.id = "rule-kind";
  const count = el("p", { class: "quiet", role: "status", id: "rule-count" });
  const list = el("ul", { id: "rule-list" });
  const show = () => {
    const { text, kind: of } = store.get(FILTER);
    const found = matching(store.get(ITEMS), text, of);
    count.replaceChildren(found.length > MOST_SHOWN ? `${String(found.length)} found, ${String(MOST_SHOWN)} shown` : `${String(found.length)} found`);
    list.replaceChildren(...found.slice(0, MOST_SHOWN).map((item) => entry(store, item)));
  };
  for (const of of [FILTER, ITEMS]) {
    store.watch(/** @type {typeof FILTER} */ (of), show);
  }
  const filter = el("div", { class: "row" }, [labelled("Filter", typed), labelled("Kind", kind)]);
  return el("section", { class: "rule-browser", "aria-label": "Rule browser" }, [filter, count, list]);
}

/**
 * @param {Store} store
 * @param {Item} item
 */
function entry(store, item) {
  const button = el("button", { type: "button", class: "link", click: () => store.set(CHOSEN, item) }, [item.name]);
  const about = [item.class, item.subtype].filter(Boolean).join(" ");
  return el("li", {}, [button, el("span", { class: "quiet" }, [` ${about}`])]);
}
