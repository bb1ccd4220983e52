/** The tabs beside the stage: what is selected, the takes, what is taken away. The arrows go from one to the next. */

import { el, found } from "../dom.js";
import { SELECTION } from "../state/performed.js";
import { slice } from "../state/slice.js";

/** @import { Store } from "../state/store.js" */

const TABS = Object.freeze({ inspected: "Inspector", taken: "Takes", exports: "Export" });

/** The id of the tab that is shown. */
export const SIDE = slice(/** @type {keyof typeof TABS} */ ("inspected"));

/**
 * @param {HTMLElement} element
 * @param {Store} store
 */
export function mountSideTabs(element, store) {
  const ids = /** @type {(keyof typeof TABS)[]} */ (Object.keys(TABS));
  for (const id of ids) {
    const show = () => store.set(SIDE, id);
    const tab = el("button", { type: "button", role: "tab", id: `tab-${id}`, "aria-controls": id, click: show }, [TABS[id]]);
    element.append(tab);
    store.watch(SIDE, (shown) => {
      tab.setAttribute("aria-selected", String(shown === id));
      found(document, `#${id}`, HTMLElement).hidden = shown !== id;
    });
  }
  element.addEventListener("keydown", ({ key }) => {
    const step = key === "ArrowRight" ? 1 : key === "ArrowLeft" ? -1 : 0;
    const next = ids[(ids.indexOf(store.get(SIDE)) + step + ids.length) % ids.length];
    if (step !== 0 && next) {
      store.set(SIDE, next);
      found(document, `#tab-${next}`, HTMLElement).focus();
    }
  });
  store.watch(SELECTION, (id) => id !== null && store.set(SIDE, "inspected"));
}
