/** The panels that show a line, by the ids of their elements. */

import { mountChanges } from "./changes/changes.js";
import { mountExports } from "./exports/exports.js";
import { mountReasons } from "./reasons/reasons.js";
import { mountStage } from "./stage/stage.js";
import { mountTakes } from "./takes/takes_panel.js";
import { mountTimeline } from "./timeline/timeline.js";

export const LINE_PANELS = Object.freeze({
  timeline: mountTimeline,
  reasons: mountReasons,
  changes: mountChanges,
  taken: mountTakes,
  exports: mountExports,
  stage: mountStage,
});
