/**
 * Another version beside the line's own, in time with it: the line as it was when it was kept, as it is without edits, or
 * with gestures from another source. It stands to the speaker's left.
 */

import { choice, el, labelled } from "../dom.js";
import { heardBefore, performed } from "../service/performing.js";
import { problemOf } from "../service/service.js";
import { PERFORMED, PROBLEM } from "../state/performed.js";
import { PROJECT } from "../state/project.js";
import { slice } from "../state/slice.js";
import { GUESTS, VIEWING } from "../stage/viewing.js";

/** @import { Service } from "../service/service.js" */
/** @import { PerformedLine } from "../state/performed.js" */
/** @import { Project } from "../state/project.js" */
/** @import { Store } from "../state/store.js" */

const ASIDE_M = 1.1;
const VERSIONS = /** @type {const} */ ([
  ["none", "Nothing"],
  ["kept", "The version that was kept"],
  ["unedited", "Without edits"],
  ["semantic", "Gestures from the meaning"],
  ["prosody", "Gestures from the stress"],
  ["random", "Gestures by chance"],
]);

/** What this version is compared with. */
export const COMPARED = slice(/** @type {string} */ ("none"));

/** The version that was kept to compare with. */
const KEPT = slice(/** @type {PerformedLine | null} */ (null));

/**
 * @param {Store} store
 * @param {Service} service
 */
export function comparison(store, service) {
  const other = choice(VERSIONS, "none", (version) => store.set(COMPARED, version));
  other.id = "compare-with";
  const keep = el("button", { type: "button", id: "keep-version", click: () => keepVersion(store) }, ["Keep this version"]);
  const told = el("p", { class: "quiet", id: "compared", role: "status" });
  let underWay = new AbortController();
  const compare = () => {
    underWay.abort();
    underWay = new AbortController();
    void stand(store, service, told, underWay.signal);
  };
  store.watch(COMPARED, (version) => {
    other.value = version;
    compare();
  });
  for (const of of [PERFORMED, KEPT]) {
    store.watch(of, compare);
  }
  return el("div", {}, [el("h3", {}, ["Beside it"]), el("div", { class: "row" }, [labelled("Compare with", other), keep]), told]);
}

/** @param {Store} store */
function keepVersion(store) {
  store.set(KEPT, store.get(PERFORMED));
  store.set(COMPARED, "kept");
}

/**
 * Has the other version stand beside the line's own.
 *
 * @param {Store} store
 * @param {Service} service
 * @param {HTMLElement} told
 * @param {AbortSignal} signal
 */
async function stand(store, service, told, signal) {
  const line = store.get(PERFORMED);
  if (!line || store.get(COMPARED) === "none") {
    told.textContent = "";
    store.set(GUESTS, []);
    return;
  }
  told.textContent = "Performing the other version…";
  try {
    const other = await otherVersion(store, service, signal);
    if (!signal.aborted) {
      told.textContent = other ? difference(line, other) : "No version was kept yet.";
      showBeside(store, other);
    }
  } catch (error) {
    if (!signal.aborted) {
      told.textContent = "";
      store.set(PROBLEM, problemOf(error));
    }
  }
}

/**
 * Has a version stand there. As it comes the camera shows both; then it is the author's again.
 *
 * @param {Store} store
 * @param {PerformedLine | null} other
 */
function showBeside(store, other) {
  const isNew = store.get(GUESTS).length === 0;
  store.set(GUESTS, other ? [guest(other)] : []);
  if (other && isNew) {
    store.patch(VIEWING, { shot: "wide" });
  }
}

/**
 * @param {Store} store
 * @param {Service} service
 * @param {AbortSignal} signal
 * @returns {Promise<PerformedLine | null>}
 */
async function otherVersion(store, service, signal) {
  const [project, version] = [store.get(PROJECT), store.get(COMPARED)];
  if (version === "kept" || !project.audio) {
    return store.get(KEPT);
  }
  const changed = { ...project, ...changeFor(project, version), audio: project.audio };
  return performed(service, changed, heardBefore(store, changed), signal);
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

/**
 * How many movements are alike, and how many each has for itself.
 *
 * @param {PerformedLine} line
 * @param {PerformedLine} other
 */
export function difference(line, other) {
  const [own, others] = [line, other].map(({ performance }) => new Set(performance.behaviors.filter(({ kept }) => kept).map(said)));
  const shared = [...(own ?? [])].filter((each) => others?.has(each)).length;
  return `${String(shared)} movements are the same; ${String((own?.size ?? 0) - shared)} only here, ${String((others?.size ?? 0) - shared)} only there.`;
}

/** @param {PerformedLine["performance"]["behaviors"][number]} behavior */
function said({ kind, lexeme, hand, sync }) {
  return JSON.stringify([kind, lexeme, hand, sync]);
}
