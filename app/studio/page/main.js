/**
 * The page: mounts the panels, which talk to each other through the store alone.
 *
 * First comes what the start page needs, then what shows a line, and each other view when it is looked at for the first
 * time: all of it together is ten times as much as the start page.
 */

import { found } from "./dom.js";
import { mountDivider } from "./frame/divider.js";
import { mountHistory } from "./frame/history_buttons.js";
import { mountPreferences } from "./frame/preferences.js";
import { mountProblem } from "./frame/problem.js";
import { mountSideTabs } from "./frame/side_tabs.js";
import { mountViews, VIEW } from "./frame/views.js";
import { openAsAsked } from "./line/opening.js";
import { mountProject } from "./line/project_form.js";
import { mountStart } from "./line/start.js";
import { keepSaved } from "./saved/autosave.js";
import { mountSaving } from "./saved/saving_state.js";
import { watchPointer } from "./redrawing.js";
import { keepPerformed } from "./service/performing.js";
import { problemOf, Service } from "./service/service.js";
import { PROBLEM } from "./state/performed.js";
import { Store } from "./state/store.js";

/** @typedef {(element: HTMLElement, store: Store, service: Service) => void} Mount */

/** The panels of a view by the ids of their elements, loaded when they are called for. @type {Record<string, () => Promise<Record<string, Mount>>>} */
const LATER = {
  line: async () => (await import("./line_panels.js")).LINE_PANELS,
  gesture_editor: async () => ({ gesture_editor: (await import("./gesture_editor/gesture_editor.js")).mountGestureEditor }),
  rules: async () => ({ rules: (await import("./rules/rules.js")).mountRules }),
  table_read: async () => ({ table_read: (await import("./table_read/table_read.js")).mountTableRead }),
};

watchPointer();
const store = new Store();
const service = new Service();

/** @param {Record<string, Mount>} panels */
function mountAll(panels) {
  for (const [id, mount] of Object.entries(panels)) {
    mount(found(document, `#${id}`, HTMLElement), store, service);
  }
}

/** @type {Set<string>} */
const called = new Set();

/**
 * Mounts what a view needs, once. Where it cannot be loaded, the next look at the view tries again.
 *
 * @param {string} view
 */
async function callFor(view) {
  const load = LATER[view];
  if (load && !called.has(view)) {
    called.add(view);
    try {
      mountAll(await load());
    } catch (error) {
      called.delete(view);
      store.set(PROBLEM, problemOf(error));
    }
  }
}

mountAll({
  history: mountHistory,
  saving: mountSaving,
  preferences: mountPreferences,
  problem: mountProblem,
  views: mountViews,
  start: mountStart,
  "side-tabs": mountSideTabs,
  divider: mountDivider,
  project: mountProject,
});
keepPerformed(store, service);
keepSaved(store);
void openAsAsked(store, service);
// After the start page is painted.
requestAnimationFrame(() => setTimeout(() => store.watch(VIEW, (view) => void callFor(view))));
