/**
 * Keeps the performance that of the project: whenever the project changes it is performed and realized again, and what
 * is under way for an earlier one is given up.
 */

import { clipFromJson } from "understudy-client";

import { BUSY, PERFORMED, PROBLEM } from "../state/performed.js";
import { PROJECT } from "../state/project.js";
import { slice } from "../state/slice.js";
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
  let underWay = new AbortController();
  store.watch(PROJECT, (project) => {
    underWay.abort();
    underWay = new AbortController();
    if (isLine(project)) {
      void performInto(store, service, project, underWay.signal);
    }
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
 * @param {Store} store
 * @param {Service} service
 * @param {Line} line
 * @param {AbortSignal} signal
 */
async function performInto(store, service, line, signal) {
  store.set(BUSY, true);
  try {
    const found = await performed(service, line, heardBefore(store, line), signal);
    if (!signal.aborted) {
      keepHeard(store, line, found);
      store.set(PERFORMED, found);
      store.set(PROBLEM, null);
    }
  } catch (error) {
    if (!signal.aborted) {
      store.set(PROBLEM, problemOf(error));
    }
  }
  if (!signal.aborted) {
    store.set(BUSY, false);
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
  if (!isCorrected) {
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
