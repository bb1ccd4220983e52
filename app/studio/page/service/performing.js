/**
 * Keeps the performance that of the project: whenever the project changes it is performed and realized again, one at a
 * time and then the latest. Only what is under way for another recording or text is given up, for that may take long.
 */

import { clipFromJson } from "understudy-client";

import { BUSY, PERFORMED, PROBLEM } from "../state/performed.js";
import { isRecorded, PROJECT } from "../state/project.js";
import { slice } from "../state/slice.js";
import { latest } from "./latest.js";
import { inRecording, performForm, realizeForm } from "./requests.js";
import { problemOf } from "./service.js";

/** @import { Edits, Performed } from "understudy-client" */
/** @import { PerformedLine } from "../state/performed.js" */
/** @import { Project } from "../state/project.js" */
/** @import { Store } from "../state/store.js" */
/** @import { Service } from "./service.js" */

/** @typedef {Project & { audio: File }} Line a project that can be performed */

const JSON_TYPE = "application/json";

/** The last performance in which every word is where it was heard, and of what. */
const HEARD = slice(/** @type {{ audio: File, text: string, line: PerformedLine } | null} */ (null));

/**
 * @param {Store} store
 * @param {Service} service
 */
export function keepPerformed(store, service) {
  let { audio, text } = store.get(PROJECT);
  let underWay = new AbortController();
  /** @type {Pick<Project, "audio" | "text">} */
  let shown = { audio: null, text: "" };
  const refresh = latest(async (isLatest) => {
    const project = store.get(PROJECT);
    if (!isLine(project)) {
      store.set(BUSY, false);
      store.set(PROBLEM, null);
      return;
    }
    const isMade = await performInto(store, service, project, { signal: underWay.signal, isLatest });
    const isSame = project.audio === shown.audio && project.text === shown.text;
    shown = isMade ? project : shown;
    if (!isMade && isLatest() && !isSame) {
      store.set(PERFORMED, null);
    }
  });
  store.watch(PROJECT, (project) => {
    if (project.audio !== audio || project.text !== text) {
      ({ audio, text } = project);
      underWay.abort();
      underWay = new AbortController();
    }
    void refresh();
  });
}

/**
 * Performs the project again, as after the key was typed or rules were changed.
 *
 * @param {Store} store
 */
export function performAgain(store) {
  store.patch(PROJECT, {});
}

/**
 * A line and its motion. Rejects as `Service.fetch`, or with the signal's reason.
 *
 * @param {Service} service
 * @param {Line} line
 * @param {PerformedLine | null} heard what was made of the same recording and text before
 * @param {AbortSignal} [signal]
 * @returns {Promise<PerformedLine>}
 */
export async function performed(service, line, heard = null, signal) {
  const request = { method: "POST", headers: { accept: JSON_TYPE }, signal: signal ?? null };
  const answered = await service.fetch("perform", { ...request, body: performForm(line, heard) });
  const answer = /** @type {Performed} */ (await answered.json());
  const played = async (/** @type {string} */ bml) => {
    const motion = await service.fetch("realize", { ...request, body: realizeForm(bml, line.audio) });
    return clipFromJson(await motion.json());
  };
  const listening = Object.entries(answer.listeners ?? {});
  const [motion, heardMotions] = await Promise.all([
    played(answer.bml),
    Promise.all(listening.map(async ([name, bml]) => /** @type {const} */ ([name, await played(bml)]))),
  ]);
  const contours = answer.contours ?? heard?.contours ?? null;
  const { performance, bml } = answer;
  return { answer, performance, bml, motion, listeners: new Map(heardMotions), contours, edits: line.edits };
}

/**
 * Shows the line as it is performed; whether it could be. What was shown of another recording or other words goes where
 * these cannot be performed.
 *
 * @param {Store} store
 * @param {Service} service
 * @param {Line} line
 * @param {{ signal: AbortSignal, isLatest: () => boolean }} under
 */
async function performInto(store, service, line, { signal, isLatest }) {
  store.set(BUSY, true);
  try {
    const found = await performed(service, line, heardBefore(store, line), signal);
    if (isLatest()) {
      keepHeard(store, line, found);
      store.set(PERFORMED, found);
      store.set(PROBLEM, null);
    }
    return true;
  } catch (error) {
    if (isLatest()) {
      store.set(PROBLEM, problemOf(error));
    }
    return false;
  } finally {
    if (isLatest()) {
      store.set(BUSY, false);
    }
  }
}

/**
 * The words where they were heard, whatever was corrected; null where nobody knows.
 *
 * @param {Store} store
 */
export function heardWords(store) {
  const last = store.get(HEARD);
  return last ? (inRecording(last.line.performance)?.words ?? null) : null;
}

/**
 * @param {Store} store
 * @param {Line} line
 * @param {PerformedLine} found
 */
function keepHeard(store, line, found) {
  const edits = /** @type {Edits | null} */ (line.edits);
  const isCorrected = edits?.words?.some(({ start_s }) => typeof start_s === "number") ?? false;
  if (!isCorrected && isRecorded(line.audio)) {
    store.set(HEARD, { audio: line.audio, text: line.text, line: found });
  }
}

/**
 * What was made of the same recording and text before, if every word in it is where it was heard.
 *
 * @param {Store} store
 * @param {Line} line
 */
export function heardBefore(store, line) {
  const last = store.get(HEARD);
  return last?.audio === line.audio && last.text === line.text && line.words === null ? last.line : null;
}

/**
 * @param {Project} project
 * @returns {project is Line}
 */
function isLine(project) {
  return project.audio !== null && project.text.trim() !== "";
}
