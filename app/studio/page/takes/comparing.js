/**
 * Another version beside the line's own, in time with it: a take, the line without edits, or with gestures from another
 * source. It stands to the speaker's left under its name; what differs is marked on the timeline.
 */

import { heardBefore, performed } from "../service/performing.js";
import { problemOf } from "../service/service.js";
import { COMPARED_NAME, GUESTS, VIEWING } from "../stage/viewing.js";
import { PERFORMED, PROBLEM } from "../state/performed.js";
import { PROJECT } from "../state/project.js";
import { slice } from "../state/slice.js";
import { DIFFERING, OTHERS } from "../timeline/compared.js";
import { differences } from "./differences.js";
import { TAKES } from "./takes.js";

/** @import { Service } from "../service/service.js" */
/** @import { PerformedLine } from "../state/performed.js" */
/** @import { Project } from "../state/project.js" */
/** @import { Store } from "../state/store.js" */
/** @import { Differences } from "./differences.js" */

const ASIDE_M = 1.1;

/** What a line can be compared with beside its takes. */
export const VERSIONS = /** @type {const} */ ([
  ["none", "Nothing"],
  ["unedited", "Without edits"],
  ["semantic", "Gestures from the meaning"],
  ["prosody", "Gestures from the stress"],
  ["random", "Gestures by chance"],
]);

/** What this version is compared with: one of VERSIONS, or the id of a take. */
export const COMPARED = slice(/** @type {string} */ ("none"));

/** What differs from the version that stands beside this one, and that one's name; null where none does. */
export const DIFFERS = slice(/** @type {Readonly<{ name: string, found: Differences }> | null} */ (null));

/** Whether the other version is being made. */
export const COMPARING = slice(false);

/**
 * @param {Store} store
 * @param {Service} service
 */
export function keepCompared(store, service) {
  let underWay = new AbortController();
  const compare = () => {
    underWay.abort();
    underWay = new AbortController();
    void stand(store, service, underWay.signal);
  };
  for (const of of [COMPARED, PERFORMED]) {
    store.watch(/** @type {typeof COMPARED} */ (of), compare);
  }
  store.watch(DIFFERS, (differs) => {
    store.set(DIFFERING, new Set(differs?.found.here.map(({ id }) => id)));
    store.set(OTHERS, differs?.found.there ?? []);
  });
  store.watch(TAKES, () => nameOf(store) === null && store.set(COMPARED, "none"));
}

/**
 * The name of what the line is compared with; null for a take that is no more.
 *
 * @param {Store} store
 */
export function nameOf(store) {
  const chosen = store.get(COMPARED);
  return VERSIONS.find(([id]) => id === chosen)?.[1] ?? store.get(TAKES).find(({ id }) => id === chosen)?.name ?? null;
}

/**
 * Has the other version stand beside the line's own.
 *
 * @param {Store} store
 * @param {Service} service
 * @param {AbortSignal} signal
 */
async function stand(store, service, signal) {
  const line = store.get(PERFORMED);
  store.set(COMPARING, line !== null && store.get(COMPARED) !== "none");
  if (!line || !store.get(COMPARING)) {
    store.set(GUESTS, []);
    store.set(DIFFERS, null);
    return;
  }
  const found = await otherVersion(store, service, signal).catch(problemOf);
  if (signal.aborted) {
    return;
  }
  store.set(COMPARING, false);
  if (found && "code" in found) {
    store.set(PROBLEM, found);
  } else if (found) {
    showBeside(store, line, found);
  }
}

/**
 * Has a version stand there. As it comes the camera shows both; then it is the author's again.
 *
 * @param {Store} store
 * @param {PerformedLine} line
 * @param {PerformedLine} other
 */
function showBeside(store, line, other) {
  store.set(DIFFERS, { name: nameOf(store) ?? "", found: differences(line, other) });
  const isNew = store.get(GUESTS).length === 0;
  store.set(COMPARED_NAME, nameOf(store) ?? "");
  store.set(GUESTS, [guest(other)]);
  if (isNew) {
    store.patch(VIEWING, { shot: "wide" });
  }
}

/** Takes as they were performed: one is the same whatever is changed in the line. @type {WeakMap<object, PerformedLine>} */
const PERFORMED_TAKES = new WeakMap();

/**
 * @param {Store} store
 * @param {Service} service
 * @param {AbortSignal} signal
 * @returns {Promise<PerformedLine | null>}
 */
async function otherVersion(store, service, signal) {
  const [project, chosen] = [store.get(PROJECT), store.get(COMPARED)];
  const take = store.get(TAKES).find(({ id }) => id === chosen);
  const known = take && PERFORMED_TAKES.get(take);
  if (known || !project.audio) {
    return known ?? null;
  }
  const changed = { ...project, ...(take?.draft ?? changeFor(project, chosen)), audio: project.audio };
  const found = await performed(service, changed, heardBefore(store, changed), signal);
  if (take) {
    PERFORMED_TAKES.set(take, found);
  }
  return found;
}

/**
 * @param {Project} project
 * @param {string} version
 * @returns {Partial<Project>}
 */
export function changeFor({ options }, version) {
  const mode = /** @type {"semantic" | "prosody" | "random"} */ (version);
  return version === "unedited" ? { edits: null } : { options: { ...options, mode } };
}

/** @param {PerformedLine} line */
function guest({ performance, motion }) {
  return {
    name: "compared",
    character: performance.character,
    motion,
    place_m: /** @type {const} */ ([ASIDE_M, 0, 0]),
    turn_rad: 0,
    avatar: null,
  };
}
