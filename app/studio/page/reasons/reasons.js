/**
 * The inspector: why what is selected is there. A rule's name asks for the rule (ASKED_RULE), which the rule browser
 * shows; its place in the rule files stands beside it.
 */

import { el, foldable } from "../dom.js";
import { problemOf } from "../service/service.js";
import { PERFORMED, PROBLEM, SELECTION } from "../state/performed.js";
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
  const told = el("div", { "aria-live": "polite" });
  element.append(foldable("Reasons", [told]));
  const show = () => {
    const line = store.get(PERFORMED);
    const id = store.get(SELECTION);
    const sections = line && id ? sectionsOn(line.performance, id) : [];
    told.replaceChildren(...(sections.length > 0 ? sections.map((each) => shown(each, store)) : [hint()]));
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

function hint() {
  return el("p", { class: "quiet" }, ["Click anything on the timeline, or choose it in the list beside it."]);
}

/**
 * @param {Section} section
 * @param {Store} store
 */
function shown({ title, told }, store) {
  return el("section", { class: "reason" }, [el("h3", {}, [title]), el("ul", {}, told.map((each) => el("li", {}, line(each, store))))]);
}

/**
 * @param {Told} told
 * @param {Store} store
 * @returns {(Node | string)[]}
 */
function line({ text, id, rule }, store) {
  if (id) {
    return [el("button", { type: "button", class: "link", click: () => store.set(SELECTION, id) }, [text])];
  }
  if (!rule) {
    return [text];
  }
  const place = store.get(PLACES).get(rule);
  const asked = el("button", { type: "button", class: "link", click: () => store.set(ASKED_RULE, rule) }, [text]);
  return place ? [asked, el("code", { class: "place" }, [place])] : [asked];
}
