/** The tabs of the page: which of its views is shown. A view says that it is one by the class `view`. */

import { el, found } from "../dom.js";
import { slice } from "../state/slice.js";

/** @import { Store } from "../state/store.js" */

const VIEWS = Object.freeze({
  line: "Line",
  gesture_editor: "Gesture editor",
  rules: "Rules",
  table_read: "Table read",
});

/** The id of the view that is shown; set it to show another. */
export const VIEW = slice(/** @type {keyof typeof VIEWS} */ ("line"));

/**
 * The page begins with the line, or with the table read where its address says `?scene=opened`.
 *
 * @param {HTMLElement} element
 * @param {Store} store
 */
export function mountViews(element, store) {
  for (const [id, name] of Object.entries(VIEWS)) {
    const show = () => store.set(VIEW, /** @type {keyof typeof VIEWS} */ (id));
    const button = el("button", { type: "button", click: show }, [name]);
    element.append(button);
    store.watch(VIEW, (view) => {
      button.setAttribute("aria-current", view === id ? "page" : "false");
      found(document, `#${id}`, HTMLElement).hidden = view !== id;
    });
  }
  if (new URLSearchParams(location.search).get("scene") === "opened") {
    store.set(VIEW, "table_read");
  }
}
