/** Rules at hand: the rule browser, the file of what is chosen, what that takes part in, and what edits change. */

import { VIEW } from "../frame/views.js";
import { ASKED_RULE } from "../reasons/reasons.js";
import { CHOSEN, explain, ITEMS, loadBook } from "./rule_book.js";
import { ruleDetails } from "./rule_details.js";
import { ruleList } from "./rule_list.js";
import { ruleText } from "./rule_text.js";

/** @import { Service } from "../service/service.js" */
/** @import { Store } from "../state/store.js" */

/**
 * Nothing is asked of the service before the rules are looked at.
 *
 * @param {HTMLElement} element
 * @param {Store} store
 * @param {Service} service
 */
export function mountRules(element, store, service) {
  let isMounted = false;
  store.watch(VIEW, (view) => {
    if (view === "rules" && !isMounted) {
      isMounted = true;
      element.append(ruleList(store, service), ruleText(store, service), ruleDetails(store));
    }
    if (view === "rules" && store.get(ITEMS).length === 0) {
      void loadBook(store, service);
    }
  });
  store.watch(CHOSEN, (item) => {
    if (item) {
      void explain(store, service, item);
    }
  });
  watchAsked(store);
}

/**
 * Shows the rule that was asked for, by its name, as soon as the rules are known.
 *
 * @param {Store} store
 */
function watchAsked(store) {
  store.watch(ASKED_RULE, (name) => {
    if (name !== null) {
      chooseAsked(store);
    }
  });
  store.watch(ITEMS, () => chooseAsked(store));
}

/** @param {Store} store */
function chooseAsked(store) {
  const name = store.get(ASKED_RULE);
  const item = store.get(ITEMS).find((each) => each.name === name);
  if (item) {
    store.set(CHOSEN, item);
    store.set(ASKED_RULE, null);
  }
}
