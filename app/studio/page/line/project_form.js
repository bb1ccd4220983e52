/** The line as its author gives it: recording, words, character, agitation, seed, stillness, mode, gesture profile. */

import { choice, el, labelled } from "../dom.js";
import { problemOf } from "../service/service.js";
import { ChangeProject } from "../state/change_project.js";
import { AVATAR, BUSY, PERFORMED, PROBLEM } from "../state/performed.js";
import { PROJECT } from "../state/project.js";
import { CHARACTERS } from "../stage/viewing.js";
import { letFilesBeDropped, takeFiles } from "./dropping.js";
import { openExample } from "./opening.js";

/** @import { Performance, PerformOptions } from "understudy-client" */
/** @import { Project } from "../state/project.js" */
/** @import { Service } from "../service/service.js" */
/** @import { Store } from "../state/store.js" */

const EXAMPLE_PROFILES = ["sparing", "sweeping"];
const LEVELS = /** @type {const} */ ([["", "As the voice"], ["low", "Low"], ["medium", "Medium"], ["high", "High"]]);
const CHOICES = /** @type {const} */ ([["", "As the character"], ["terms", "By everything"], ["priority", "By priority"]]);
const MODES = /** @type {const} */ ([["semantic", "Meaning"], ["prosody", "Stress"], ["random", "Chance"]]);

/**
 * @param {HTMLElement} element
 * @param {Store} store
 * @param {Service} service
 */
export function mountProject(element, store, service) {
  letFilesBeDropped(store);
  element.append(files(store, service), words(store), state(store), options(store, service));
}

/**
 * @param {Store} store
 * @param {Service} service
 */
function files(store, service) {
  const chosen = el("input", { type: "file", id: "files", multiple: true, accept: ".wav,.flac,.ogg,.txt,.glb,.vrm,.zip" });
  chosen.addEventListener("change", () => void takeFiles(store, [...(chosen.files ?? [])]));
  const example = el("button", { type: "button", id: "example", click: () => void openExample(store, service) }, ["Example"]);
  const ours = el("button", { type: "button", click: () => store.set(AVATAR, null) }, ["Our body again"]);
  store.watch(AVATAR, (avatar) => (ours.hidden = avatar === null));
  return el("div", { class: "row" }, [labelled("Recording, words (.txt), body (.glb, .vrm) or project (.zip)", chosen), example, ours]);
}

/** @param {Store} store */
function words(store) {
  const typed = el("textarea", { id: "text", rows: 4, spellcheck: true });
  const change = () => store.history.execute(new ChangeProject(store, "Words", { text: typed.value }));
  typed.addEventListener("change", change);
  store.watch(PROJECT, ({ text }) => {
    if (typed.value !== text) {
      typed.value = text;
    }
  });
  return labelled("Words that are spoken", typed);
}

/**
 * @param {Store} store
 * @param {Service} service
 */
function options(store, service) {
  const character = choice([["default", "default"]], "default", (value) => setOption(store, "character", value));
  void fillCharacters(character, store, service);
  const agitation = choice(LEVELS, "", (value) => setOption(store, "agitation", value || undefined));
  const chosen = choice(CHOICES, "", (value) => setOption(store, "choice", value || undefined));
  const mode = choice(MODES, "semantic", (value) => setOption(store, "mode", value));
  const seed = el("input", { type: "number", step: 1, value: 0, id: "seed" });
  seed.addEventListener("change", () => setOption(store, "seed", Number(seed.value)));
  const stillness = el("input", { type: "range", min: 0, max: 1, step: 0.05, value: 0, id: "stillness" });
  stillness.addEventListener("change", () => setOption(store, "stillness", Number(stillness.value)));
  const [profile, examples] = profileField(store);
  store.watch(PROJECT, ({ options: now }) => {
    profile.value = now.profile ?? "";
    character.value = now.character ?? "default";
    agitation.value = now.agitation ?? "";
    chosen.value = now.choice ?? "";
    mode.value = now.mode ?? "semantic";
    seed.value = String(now.seed ?? 0);
    stillness.value = String(now.stillness ?? 0);
  });
  const controls = { Character: character, Agitation: agitation, "Movements chosen": chosen, "Gestures from": mode, Seed: seed, Stillness: stillness, "Gesture profile": profile };
  return el("div", { class: "pair" }, [...Object.entries(controls).map(([name, control]) => labelled(name, control)), examples]);
}

/**
 * Whose gestures are made: a name is typed, for the service may know others than our examples.
 *
 * @param {Store} store
 * @returns {[HTMLInputElement, HTMLDataListElement]}
 */
function profileField(store) {
  const names = el("datalist", { id: "profiles" }, EXAMPLE_PROFILES.map((name) => el("option", { value: name })));
  const typed = el("input", { type: "text", id: "profile", placeholder: "nobody's", spellcheck: false });
  typed.setAttribute("list", names.id);
  typed.addEventListener("change", () => setOption(store, "profile", typed.value.trim() || undefined));
  return [typed, names];
}

/**
 * @param {HTMLSelectElement} select
 * @param {Store} store
 * @param {Service} service
 */
async function fillCharacters(select, store, service) {
  try {
    const { characters } = await service.client.listCharacters();
    store.set(CHARACTERS, characters.map(({ name }) => name));
    select.replaceChildren(...characters.map(({ name }) => el("option", { value: name }, [name])));
    select.value = store.get(PROJECT).options.character ?? "default";
  } catch (error) {
    store.set(PROBLEM, problemOf(error));
  }
}

/** @param {Store} store */
function state(store) {
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
    return "Drop a recording on the page and type its words, or press Example.";
  }
  return text.trim() ? null : `Type the words that are spoken in ${audio.name}.`;
}

/**
 * What was performed, and what was guessed or left out.
 *
 * @param {Performance} performance
 */
function summary({ audio, agitation, behaviors, warnings }) {
  const kept = behaviors.filter((each) => each.kept).length;
  const done = `${audio.duration_s.toFixed(2)} s, agitation ${agitation}, ${String(kept)} behaviours`;
  return [done, ...warnings.map(({ message }) => message)].join(" — ");
}

/**
 * @param {Store} store
 * @param {keyof PerformOptions} name
 * @param {unknown} value
 */
function setOption(store, name, value) {
  const changed = { options: { ...store.get(PROJECT).options, [name]: value } };
  store.history.execute(new ChangeProject(store, name, changed));
}
