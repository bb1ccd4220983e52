/** What a rule is, rests on and leads to; and what edited rules change in the example lines. */

import { el } from "../dom.js";
import { plain } from "../naming/movements.js";
import { CHOSEN, COMPARED, EXPLAINED, TRYING } from "./rule_book.js";
import { toldChanges } from "./telling_changes.js";

/** @import { RuleComparison, RuleExplanations } from "understudy-client" */
/** @import { Store } from "../state/store.js" */
/** @import { Item } from "./rule_book.js" */

const MOST_NAMED = 30;

/** How what is gone, new or other than before looks. */
const KINDS = Object.freeze({ "−": "gone", "+": "new", "~": "other" });

/** @param {Store} store */
export function ruleDetails(store) {
  const hint = el("p", { class: "quiet" }, ["Here you read what a rule comes from, what it leads to, and what your changes do to other lines."]);
  const explained = el("div", { id: "rule-explained" });
  const compared = el("div", { id: "rules-compared", role: "status" });
  store.watch(EXPLAINED, (found) => explained.replaceChildren(...(found ? explanations(store, found) : [hint])));
  const compare = () => {
    const found = store.get(COMPARED);
    const asked = el("p", { class: "quiet" }, ["Reading every example line with your changes and without…"]);
    compared.replaceChildren(...(store.get(TRYING) ? [asked] : found ? comparison(found) : []));
  };
  store.watch(COMPARED, compare);
  store.watch(TRYING, compare);
  return el("section", { class: "rule-details", "aria-label": "About the rule" }, [compared, explained]);
}

/**
 * @param {Store} store
 * @param {RuleExplanations} found
 */
function explanations(store, { items }) {
  return items.map((item) =>
    el("article", {}, [
      el("h2", { title: item.name }, [plain(item.name)]),
      el("p", {}, [item.comment]),
      el("p", { class: "quiet" }, [`${item.file}:${String(item.line)}`]),
      el("pre", {}, [item.source]),
      ...related(store, "Comes from", item.comes_from),
      ...related(store, "Leads to", item.leads_to),
    ]),
  );
}

/**
 * @param {Store} store
 * @param {string} title
 * @param {readonly Item[]} items
 */
function related(store, title, items) {
  const links = items.slice(0, MOST_NAMED).flatMap((item) => [
    el("button", { type: "button", class: "link", title: item.name, click: () => store.set(CHOSEN, item) }, [plain(item.name)]),
    ", ",
  ]).slice(0, -1);
  const more = items.length > MOST_NAMED ? [` and ${String(items.length - MOST_NAMED)} more`] : [];
  return items.length > 0 ? [el("h3", {}, [title]), el("p", {}, [...links, ...more])] : [];
}

/** @param {RuleComparison} compared */
function comparison({ lines, changes }) {
  const title = changes.length === 0 ? `None of ${String(lines)} example lines changes` : `${String(changes.length)} of ${String(lines)} example lines change${changes.length > 1 ? "" : "s"}`;
  return [
    el("h2", {}, [title]),
    ...changes.map((change) => {
      const told = toldChanges(change).map(({ sign, text, technical }) => el("li", { class: KINDS[sign], title: technical }, [`${sign} ${text}`]));
      return el("article", { class: "changed-line" }, [el("h3", {}, [change.text]), el("ul", {}, told)]);
    }),
  ];
}
