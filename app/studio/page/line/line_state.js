/** What is known of the line: what it still lacks, that it is being performed, or what came of it. */

import { el } from "../dom.js";
import { BUSY, PERFORMED } from "../state/performed.js";
import { isRecorded, PROJECT } from "../state/project.js";

/** @import { Performance } from "understudy-client" */
/** @import { Project } from "../state/project.js" */
/** @import { Store } from "../state/store.js" */

/** @param {Store} store */
export function lineState(store) {
  const told = el("p", { id: "state", role: "status" });
  const tell = () => {
    const line = store.get(PERFORMED);
    const done = lacking(store.get(PROJECT)) ?? (line ? summary(line.performance) : "");
    told.replaceChildren(store.get(BUSY) ? "Performing…" : done);
  };
  for (const of of [BUSY, PERFORMED, PROJECT]) {
    store.watch(/** @type {typeof BUSY} */ (of), tell);
  }
  return told;
}

/**
 * What a line still needs to be performed; null where it has all.
 *
 * @param {Project} project
 */
function lacking({ audio, text }) {
  if (!audio) {
    return "Drop a recording on the page and type its words.";
  }
  if (text.trim()) {
    return null;
  }
  return isRecorded(audio) ? `Type the words that are spoken in ${audio.name}.` : "Type the words of the line.";
}

/**
 * What was performed, and what was guessed or left out.
 *
 * @param {Performance} performance
 */
function summary({ audio, behaviors, warnings }) {
  const kept = behaviors.filter((each) => each.kept).length;
  const done = `${audio.duration_s.toFixed(2)} s · ${String(kept)} movements`;
  return [done, ...warnings.map(({ message }) => message)].join(" — ");
}
