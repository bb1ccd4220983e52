/**
 * Why what is selected is there, to the last number: behind a fold, for the inspector says it in a sentence. A rule's name asks for the rule
 * (ASKED_RULE), which the rule browser shows; its place in the rule files stands beside it.
 */

import { el } from "../dom.js";
import { VIEW } from "../frame/views.js";
import { problemOf } from "../service/service.js";
import { PERFORMED, PROBLEM, SELECTION } from "../state/performed.js";
import { selectAndSeek } from "../state/selecting.js";
import { slice } from "../state/slice.js";
import { sectionsOn } from "./telling.js";

/** @import { Service } from "../service/service.js" */
/** @import { Store } from "../state/store.js" */
/** @import { Section, Told } from "./telling.js" */

/** The name of the rule that was asked for; whoever shows rules watches it. */
export const ASKED_RULE = slice(/** @type {string | null} */ (null));

/** Where rules are (`file:line`) by their names. */
const PLACES = slice(/** @type {ReadonlyMap<string, string>} */ (new Map()));

/**
 * @param {HTMLElement} element
 * @param {Store} store
 * @param {Service} service
 */
export function mountReasons(element, store, service) {
  const numbers = el("div", {});
  const fold = el("details", { class: "part", id: "numbers" }, [el("summary", {}, ["Rules and numbers"]), numbers]);
  element.append(fold);
  const show = () => {
    const line = store.get(PERFORMED);
    const id = store.get(SELECTION);
    const sections = line && id ? sectionsOn(line.performance, id) : [];
    element.hidden = sections.length === 0;
    numbers.replaceChildren(...sections.map((each) => shown(each, store)));
  };
  for (const of of [PERFORMED, SELECTION, PLACES]) {
    store.watch(/** @type {typeof SELECTION} */ (of), show);
  }
  askOnce(store, service);
}

/**
 * Asks where rules are when there is something to say of them.
 *
 * @param {Store} store
 * @param {Service} service
 */
function askOnce(store, service) {
  let isAsked = false;
  store.watch(PERFORMED, (line) => {
    if (line && !isAsked) {
      isAsked = true;
      service.client.listRules().then(
        ({ rules }) => store.set(PLACES, new Map(rules.map(({ name, file, line: number }) => [name, `${file}:${String(number)}`]))),
        (error) => store.set(PROBLEM, problemOf(error)),
      );
    }
  });
}

/**
 * @param {Section} section
 * @param {Store} store
 */
function shown({ title, told }, store) {
  return el("section", { class: "reason" }, [el("h3", {}, [title]), el("ul", {}, told.map((each) => el("li", {}, line(each, store))))]);
}

/**
 * Shows the view of the rules at once; it may still have to be loaded, and the rules with it.
 *
 * @param {Store} store
 * @param {string} rule
 */
function askFor(store, rule) {
  store.set(ASKED_RULE, rule);
  store.set(VIEW, "rules");
}

/**
 * @param {Told} told
 * @param {Store} store
 * @returns {(Node | string)[]}
 */
function line({ text, id, rule }, store) {
  if (id) {
    return [el("button", { type: "button", class: "link", click: () => selectAndSeek(store, id) }, [text])];
  }
  if (!rule) {
    return [text];
  }
  const place = store.get(PLACES).get(rule);
  const asked = el("button", { type: "button", class: "link", click: () => askFor(store, rule) }, [text]);
  return place ? [asked, el("code", { class: "place" }, [place])] : [asked];
}
