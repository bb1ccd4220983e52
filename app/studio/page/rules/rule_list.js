/** The rule browser: everything that authors edit, in groups by what it is about, or filtered by words and kind. */

import { choice, el, labelled } from "../dom.js";
import { plain } from "../naming/movements.js";
import { slice } from "../state/slice.js";
import { groupsOf, matching, MOST_SHOWN } from "./choosing_rules.js";
import { newCharacter } from "./new_character.js";
import { CHOSEN, ITEMS } from "./rule_book.js";

/** @import { Service } from "../service/service.js" */
/** @import { Store } from "../state/store.js" */
/** @import { Item } from "./rule_book.js" */

const KINDS = /** @type {const} */ ([["", "Everything"], ["function", "What a line means"], ["behavior", "What is done for it"], ["bml", "Movements"], ["word", "Words"], ["file", "Characters, weights"]]);

const FILTER = slice({ text: "", kind: "" });

/**
 * @param {Store} store
 * @param {Service} service
 */
export function ruleList(store, service) {
  const typed = el("input", { id: "rule-filter", type: "search", autocomplete: "off", spellcheck: false, placeholder: "negation, yes, point…" });
  typed.addEventListener("input", () => store.patch(FILTER, { text: typed.value }));
  const kind = choice(KINDS, "", (value) => store.patch(FILTER, { kind: value }));
  kind.id = "rule-kind";
  const count = el("p", { class: "quiet", role: "status", id: "rule-count" });
  const list = el("ul", { id: "rule-list" });
  const show = () => {
    const { text, kind: of } = store.get(FILTER);
    const found = matching(store.get(ITEMS), text, of);
    count.textContent = toldCount(store.get(ITEMS).length, found.length, text, text !== "" || of !== "");
    list.replaceChildren(...(text ? found.slice(0, MOST_SHOWN).map((item) => entry(store, item)) : groupsOf(found).map((each) => group(store, each))));
  };
  for (const of of [FILTER, ITEMS]) {
    store.watch(/** @type {typeof FILTER} */ (of), show);
  }
  const filter = el("div", { class: "row" }, [labelled("Search", typed), labelled("Kind", kind)]);
  return el("section", { class: "rule-browser", "aria-label": "Rule browser" }, [filter, newCharacter(store, service), count, list]);
}

/**
 * How many there are, of which some are found; none at all before they are loaded.
 *
 * @param {number} all
 * @param {number} found
 * @param {string} text
 * @param {boolean} isFiltered
 */
function toldCount(all, found, text, isFiltered) {
  const count = found.toLocaleString("en");
  if (all === 0) {
    return "Loading rules…";
  }
  return text && found > MOST_SHOWN ? `${String(MOST_SHOWN)} of ${count} shown` : `${count} ${isFiltered ? "found" : "rules and words"}`;
}

/**
 * A group, whose items are listed when it is opened.
 *
 * @param {Store} store
 * @param {Readonly<{ name: string, items: readonly Item[] }>} group
 */
function group(store, { name, items }) {
  const list = el("ul", {});
  const fold = el("details", { class: "part" }, [el("summary", {}, [el("span", {}, [plain(name)]), el("span", { class: "quiet" }, [String(items.length)])]), list]);
  fold.addEventListener("toggle", () => list.childElementCount === 0 && list.append(...items.map((item) => entry(store, item))));
  return el("li", {}, [fold]);
}

/**
 * @param {Store} store
 * @param {Item} item
 */
function entry(store, item) {
  const button = el("button", { type: "button", class: "link", "data-name": item.name, title: item.name, click: () => store.set(CHOSEN, item) }, [plain(item.name)]);
  const about = plain([item.class, item.subtype].filter(Boolean).join(" ")).toLowerCase().replaceAll("|", " or ");
  return el("li", {}, [button, el("span", { class: "quiet" }, [` ${about}`])]);
}
