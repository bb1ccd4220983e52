/**
 * Keeps the line in this browser a moment after each change, and one that is nowhere else as soon as it is opened. What is
 * not kept yet, or cannot be, is asked about before the page goes; a page that is loaded again shows the line as it was.
 */

import { DOABLE } from "../state/history.js";
import { draftOf, OPENED, PROJECT } from "../state/project.js";
import { slice } from "../state/slice.js";
import { TAKES } from "../takes/takes.js";
import { keep, kept, keepVersion } from "./shelf.js";

/** @import { Store } from "../state/store.js" */
/** @import { Draft } from "../state/project.js" */

/** Whether what was changed is kept: `same` where nothing was changed. @typedef {"same" | "unsaved" | "saved" | "failed"} Saving */

const QUIET_MS = 300;
const LAST = "understudy-open";

export const SAVING = slice(/** @type {Saving} */ ("same"));

/** @param {Store} store */
export function keepSaved(store) {
  let timer = 0;
  let [kept, waiting] = ["", ""];
  const save = (/** @type {string} */ id) => {
    clearTimeout(timer);
    [kept, waiting] = [id, ""];
    return saveNow(store, id);
  };
  const changed = () => {
    clearTimeout(timer);
    waiting = "";
    // What was kept once is kept again as it was before, when everything is undone.
    const isChanged = store.get(PROJECT).audio !== null && (isOther(store) || kept === store.get(OPENED).id);
    store.set(SAVING, isChanged ? "unsaved" : "same");
    if (isChanged) {
      const { id } = store.get(OPENED);
      waiting = id;
      timer = window.setTimeout(() => void save(id), QUIET_MS);
    }
  };
  for (const of of [PROJECT, TAKES]) {
    store.watch(/** @type {typeof PROJECT} */ (of), changed);
  }
  // Another line is opened before its project is there: what waits is kept while it still can be.
  store.watch(OPENED, () => waiting && void save(waiting));
  beforeLeaving(store, () => void save(store.get(OPENED).id));
}

/**
 * @param {Store} store
 * @param {() => void} save
 */
function beforeLeaving(store, save) {
  document.addEventListener("visibilitychange", () => store.get(SAVING) === "unsaved" && save());
  addEventListener("beforeunload", (event) => {
    if (mayBeLost(store.get(SAVING))) {
      event.preventDefault();
    }
  });
}

/** @param {Saving} saving */
export function mayBeLost(saving) {
  return saving === "unsaved" || saving === "failed";
}

/**
 * Whether the line is another than what is found again without being kept.
 *
 * @param {Store} store
 */
function isOther(store) {
  const { kept } = store.get(OPENED);
  const now = [draftOf(store.get(PROJECT)), store.get(TAKES)];
  return kept === null || JSON.stringify(now) !== JSON.stringify([draftOf(kept.project), kept.takes]);
}

/**
 * @param {Store} store
 * @param {string} id of the line
 */
async function saveNow(store, id) {
  const { audio } = store.get(PROJECT);
  const draft = draftOf(store.get(PROJECT));
  if (!audio) {
    return;
  }
  const saved_ms = Date.now();
  const label = store.get(DOABLE).undo ?? "Opened";
  try {
    await keep({ id, audio, draft, takes: store.get(TAKES), saved_ms });
    await keepVersion({ project: id, draft, label, saved_ms });
    if (id === store.get(OPENED).id) {
      sessionStorage.setItem(LAST, JSON.stringify({ id, at: location.search }));
    }
    tell(store, draft, "saved");
  } catch {
    // The page says so, asks before it goes, and saves again at the next change.
    tell(store, draft, "failed");
  }
}

/**
 * @param {Store} store
 * @param {Draft} draft what was saved: where the line has changed since, that is still to be
 * @param {Saving} saving
 */
function tell(store, draft, saving) {
  if (JSON.stringify(draftOf(store.get(PROJECT))) === JSON.stringify(draft)) {
    store.set(SAVING, saving);
  }
}

/** The line that this tab showed before it was loaded again; undefined where it showed none, or was opened anew. */
export async function lineBefore() {
  const [entry] = performance.getEntriesByType("navigation");
  const last = JSON.parse(sessionStorage.getItem(LAST) ?? "null");
  const isAgain = entry instanceof PerformanceNavigationTiming && entry.type !== "navigate";
  return isAgain && last?.at === location.search ? kept(last.id).catch(() => undefined) : undefined;
}
