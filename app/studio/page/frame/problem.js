/** Shows what was refused, in the words of whoever refused, in the view where it was; asks for the key where one is missing. */

import { el, labelled } from "../dom.js";
import { performAgain } from "../service/performing.js";
import { PROBLEM } from "../state/performed.js";
import { PROJECT } from "../state/project.js";
import { VIEW } from "./views.js";

/** @import { Service } from "../service/service.js" */
/** @import { Store } from "../state/store.js" */

const KEY_WRONG = "key_wrong";

/**
 * @param {HTMLElement} element
 * @param {Store} store
 * @param {Service} service
 */
export function mountProblem(element, store, service) {
  let place = store.get(VIEW);
  const show = () => {
    const problem = store.get(PROBLEM);
    element.hidden = problem === null || (problem.code !== KEY_WRONG && store.get(VIEW) !== place);
  };
  store.watch(VIEW, show);
  store.watch(PROBLEM, (problem) => {
    place = store.get(VIEW);
    show();
    element.replaceChildren();
    if (problem) {
      const close = el("button", { type: "button", click: () => store.set(PROBLEM, null) }, ["Close"]);
      const needsKey = problem.code === KEY_WRONG;
      element.append(el("code", {}, [problem.code]), el("span", {}, [problem.detail]), needsKey ? keyForm(store, service) : close);
    }
  });
}

/**
 * @param {Store} store
 * @param {Service} service
 */
function keyForm(store, service) {
  const typed = el("input", { type: "password", autocomplete: "off", required: true });
  const send = (/** @type {Event} */ event) => {
    event.preventDefault();
    service.key = typed.value;
    store.set(PROBLEM, null);
    // With no line yet it was the page's own questions that were refused: all are asked again.
    if (store.get(PROJECT).audio === null) {
      location.reload();
    } else {
      performAgain(store);
    }
  };
  return el("form", { submit: send }, [labelled("API key", typed), el("button", {}, ["Use this key"])]);
}
