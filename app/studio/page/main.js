/** The page: mounts the panels, which talk to each other through the store alone. */

import { mountChanges } from "./changes/changes.js";
import { found } from "./dom.js";
import { mountDivider } from "./frame/divider.js";
import { mountExports } from "./exports/exports.js";
import { mountHistory } from "./frame/history_buttons.js";
import { mountPreferences } from "./frame/preferences.js";
import { mountProblem } from "./frame/problem.js";
import { mountSideTabs } from "./frame/side_tabs.js";
import { mountViews } from "./frame/views.js";
import { mountGestureEditor } from "./gesture_editor/gesture_editor.js";
import { openAsAsked } from "./line/opening.js";
import { mountProject } from "./line/project_form.js";
import { mountStart } from "./line/start.js";
import { mountReasons } from "./reasons/reasons.js";
import { mountRules } from "./rules/rules.js";
import { keepSaved } from "./saved/autosave.js";
import { mountSaving } from "./saved/saving_state.js";
import { watchPointer } from "./redrawing.js";
import { keepPerformed } from "./service/performing.js";
import { Service } from "./service/service.js";
import { mountStage } from "./stage/stage.js";
import { Store } from "./state/store.js";
import { mountTableRead } from "./table_read/table_read.js";
import { mountTakes } from "./takes/takes_panel.js";
import { mountTimeline } from "./timeline/timeline.js";

watchPointer();
const store = new Store();
const service = new Service();
const panels = {
  history: mountHistory,
  saving: mountSaving,
  preferences: mountPreferences,
  problem: mountProblem,
  views: mountViews,
  start: mountStart,
  "side-tabs": mountSideTabs,
  divider: mountDivider,
  project: mountProject,
  timeline: mountTimeline,
  reasons: mountReasons,
  changes: mountChanges,
  taken: mountTakes,
  exports: mountExports,
  stage: mountStage,
  gesture_editor: mountGestureEditor,
  rules: mountRules,
  table_read: mountTableRead,
};
for (const [id, mount] of Object.entries(panels)) {
  mount(found(document, `#${id}`, HTMLElement), store, service);
}
keepPerformed(store, service);
keepSaved(store);
void openAsAsked(store, service);
