/** The line as its author gives it: recording, words, character, agitation, seed, stillness, mode, gesture profile. */

import { choice, el, foldable, found, labelled } from "../dom.js";
import { AGITATION, plain } from "../naming/movements.js";
import { strongest } from "../naming/tones.js";
import { problemOf } from "../service/service.js";
import { ChangeProject } from "../state/change_project.js";
import { AVATAR, PERFORMED, PROBLEM } from "../state/performed.js";
import { isRecorded, PROJECT, titleOf } from "../state/project.js";
import { CHARACTERS } from "../stage/viewing.js";
import { lineState } from "./line_state.js";
import { STARTING } from "./starting.js";

/** @import { Performance, PerformOptions } from "understudy-client" */
/** @import { Service } from "../service/service.js" */
/** @import { Store } from "../state/store.js" */

/** Under this name the browser keeps whether the rare settings are seen. */
const UNFOLDED = "understudy-advanced";
const EXAMPLE_PROFILES = ["sparing", "sweeping"];
const AS_HEARD = "As heard";
const TONES = /** @type {const} */ (["neutral", "happy", "sad", "angry", "afraid", "disgusted", "surprised"]);
const CHOICES = /** @type {const} */ ([["", "Default"], ["terms", "All evidence"], ["priority", "Priority only"]]);
/** What fields are called whose option has another name. @type {Readonly<Partial<Record<keyof PerformOptions, string>>>} */
const CALLED = Object.freeze({ affect: "Feeling", mode: "Gestures from" });
const MODES = /** @type {const} */ ([["semantic", "Meaning"], ["prosody", "Stress"], ["random", "Chance"]]);

/**
 * @param {HTMLElement} element
 * @param {Store} store
 * @param {Service} service
 */
export function mountProject(element, store, service) {
  element.append(title(store), words(store), lineState(store), options(store, service));
}

/** What is open, and the way to something else. @param {Store} store */
function title(store) {
  const name = el("h2", {}, []);
  store.watch(PROJECT, ({ audio, text }) => ([name.textContent, name.title] = audio ? [titleOf(audio, text), audio.name] : ["", ""]));
  const other = el("button", { type: "button", id: "open-another", click: () => store.set(STARTING, true) }, ["Open…"]);
  const blank = el("button", { type: "button", id: "new-line", title: "Type a new line, or give its recording", click: () => startWriting(store) }, ["New"]);
  const ours = el("button", { type: "button", click: () => store.set(AVATAR, null) }, ["Use the default body"]);
  store.watch(AVATAR, (avatar) => (ours.hidden = avatar === null));
  return el("div", {}, [el("div", { class: "title" }, [name, blank, other]), ours]);
}

/** The start page, ready to type on. @param {Store} store */
function startWriting(store) {
  store.set(STARTING, true);
  found(document, "#written", HTMLTextAreaElement).focus();
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
  return labelled("Words", typed);
}

/**
 * @param {Store} store
 * @param {Service} service
 */
function options(store, service) {
  const character = choice([["default", plain("default")]], "default", (value) => setOption(store, "character", value));
  void fillCharacters(character, store, service);
  const seed = el("input", { type: "number", step: 1, value: 0, id: "seed" });
  seed.addEventListener("change", () => setOption(store, "seed", Number(seed.value)));
  const hint = "Reduces all movement that the words do not ask for: on the left none of it, on the right nearly all";
  const stillness = el("input", { type: "range", min: 0, max: 1, step: 0.05, value: 0, id: "stillness", title: hint });
  stillness.addEventListener("change", () => setOption(store, "stillness", Number(stillness.value)));
  const [profile, examples] = profileField(store);
  const chosen = chosenOptions(store);
  const controls = { character, seed, stillness, profile, ...chosen };
  store.watch(PROJECT, ({ options: now }) => {
    for (const [name, control] of Object.entries(controls)) {
      control.value = shownValue(now[/** @type {keyof PerformOptions} */ (name)] ?? USUAL[name]);
    }
  });
  const first = { Feeling: chosen.affect, Agitation: chosen.agitation, Stillness: stillness, Character: character };
  const rare = { Seed: seed, Choice: chosen.choice, "Gestures from": chosen.mode, Profile: profile };
  const rows = (/** @type {Record<string, HTMLElement>} */ named) =>
    el("div", { class: "rows" }, Object.entries(named).map(([name, control]) => labelled(name, control)));
  return el("div", { class: "settings" }, [el("h3", {}, ["Delivery"]), rows(first), advanced([rows(rare), examples])]);
}

/**
 * What few change: folded, unless it was unfolded in this browser before.
 *
 * @param {readonly Node[]} parts
 */
function advanced(parts) {
  const made = foldable("Advanced", parts);
  made.open = localStorage.getItem(UNFOLDED) === "yes";
  made.addEventListener("toggle", () => localStorage.setItem(UNFOLDED, made.open ? "yes" : "no"));
  return made;
}

/** What fields show of options that were not set. @type {Readonly<Record<string, string>>} */
const USUAL = Object.freeze({ character: "default", mode: "semantic", seed: "0", stillness: "0" });

/** @param {unknown} value a feeling may be a list of numbers, which no field here shows */
function shownValue(value) {
  return typeof value === "string" || typeof value === "number" ? String(value) : "";
}

/** @param {Store} store */
function chosenOptions(store) {
  const tones = TONES.map((tone) => /** @type {const} */ ([tone, plain(tone)]));
  const of = (/** @type {readonly (readonly [string, string])[]} */ values, /** @type {keyof PerformOptions} */ name) =>
    choice(values, "", (value) => setOption(store, name, value || undefined));
  const affect = of([["", AS_HEARD], ...tones], "affect");
  const agitation = of([["", AS_HEARD], ...AGITATION], "agitation");
  [affect.id, agitation.id] = ["feeling", "agitation"];
  agitation.title = "How excited the voice is: a calm one moves little, an agitated one often, wide and fast";
  tellWhatIsHeard(store, "agitation", { field: agitation, heard: (performance) => levelName(performance.agitation) });
  tellWhatIsHeard(store, "affect", { field: affect, heard: heardFeeling });
  return { agitation, affect, choice: of(CHOICES, "choice"), mode: of(MODES, "mode") };
}

/**
 * Where nothing else is chosen, the field says what was heard, or made of the words where there is nothing to hear.
 *
 * @param {Store} store
 * @param {"agitation" | "affect"} name
 * @param {{ field: HTMLSelectElement, heard: (performance: Performance) => string | undefined }} told
 */
function tellWhatIsHeard(store, name, { field, heard }) {
  store.watch(PERFORMED, (line) => {
    const { audio } = store.get(PROJECT);
    const isHeard = audio === null || isRecorded(audio);
    const said = line && !store.get(PROJECT).options[name] ? heard(line.performance) : undefined;
    const [first] = field.options;
    if (first) {
      first.text = said ? `${isHeard ? "Heard" : "By itself"}: ${said.toLowerCase()}` : isHeard ? AS_HEARD : "By itself";
    }
  });
}

/** @param {string} level */
function levelName(level) {
  return AGITATION.find(([name]) => name === level)?.[1];
}

/**
 * The feeling of all phrases; of one line they may be several.
 *
 * @param {Performance} performance
 */
function heardFeeling({ affect }) {
  const tones = new Set(affect?.phrases.map((phrase) => strongest(phrase.tones)[0]));
  return tones.size > 1 ? "several" : [...tones][0];
}

/**
 * Whose gestures are made: a name is typed, for the service may know others than our examples.
 *
 * @param {Store} store
 * @returns {[HTMLInputElement, HTMLDataListElement]}
 */
function profileField(store) {
  const names = el("datalist", { id: "profiles" }, EXAMPLE_PROFILES.map((name) => el("option", { value: name })));
  const typed = el("input", { type: "text", id: "profile", placeholder: "None", spellcheck: false });
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
    select.replaceChildren(...characters.map(({ name }) => el("option", { value: name }, [plain(name)])));
    select.value = store.get(PROJECT).options.character ?? "default";
  } catch (error) {
    store.set(PROBLEM, problemOf(error));
  }
}

/**
 * @param {Store} store
 * @param {keyof PerformOptions} name
 * @param {unknown} value
 */
function setOption(store, name, value) {
  const changed = { options: { ...store.get(PROJECT).options, [name]: value } };
  store.history.execute(new ChangeProject(store, CALLED[name] ?? plain(name), changed));
}
