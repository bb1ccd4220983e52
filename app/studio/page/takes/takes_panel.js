/** The panel of takes: another one, those that are kept, which of them stands beside the line, and what differs. */

import { choice, el, labelled } from "../dom.js";
import { icon } from "../icons.js";
import { movementName } from "../naming/movements.js";
import { redraw } from "../redrawing.js";
import { draftOf, PROJECT } from "../state/project.js";
import { seekTo, selectAndSeek } from "../state/selecting.js";
import { COMPARED, COMPARING, DIFFERS, keepCompared, nameOf, VERSIONS } from "./comparing.js";
import { toldDifferences } from "./differences.js";
import { anotherTake, forgetTake, keepTake, takeOf, TAKES, useTake } from "./takes.js";

/** @import { Behavior, Edits } from "understudy-client" */
/** @import { Service } from "../service/service.js" */
/** @import { Store } from "../state/store.js" */
/** @import { Take } from "./takes.js" */

/**
 * @param {HTMLElement} element
 * @param {Store} store
 * @param {Service} service
 */
export function mountTakes(element, store, service) {
  const another = el("button", { type: "button", id: "another-take", title: "Keeps the line as it is, and performs it once more in another way" }, [icon("add"), "New take"]);
  const keep = el("button", { type: "button", id: "keep-version", title: "Keeps the line that you edit as a take, as it is now, while you go on with it" }, ["Keep this line"]);
  another.addEventListener("click", () => store.set(COMPARED, anotherTake(store).id));
  keep.addEventListener("click", () => store.set(COMPARED, keepTake(store).id));
  const hint = el("p", { class: "quiet" }, ["A take is the line as it is performed now. A new one keeps it and tries another way; both stand side by side, and you go on with the one you like."]);
  const list = el("ul", { class: "takes", "aria-label": "Takes" });
  store.watch(TAKES, (takes) => (hint.hidden = takes.length > 0));
  const told = el("p", { class: "quiet", id: "compared", role: "status" });
  const found = el("ul", { class: "differences" });
  element.append(el("h2", {}, ["Takes"]), hint, el("div", { class: "row" }, [another, keep]), list, comparedWith(store), told, found);
  for (const of of [TAKES, PROJECT, COMPARED]) {
    store.watch(/** @type {typeof COMPARED} */ (of), () => redraw(list, store.get(TAKES).map((take) => entry(store, take))));
  }
  const tell = () => {
    told.textContent = store.get(COMPARING) ? "Performing the other version…" : toldOf(store);
    found.replaceChildren(...differing(store));
  };
  store.watch(DIFFERS, tell);
  store.watch(COMPARING, tell);
  keepCompared(store, service);
}

/** @param {Store} store */
function comparedWith(store) {
  const element = el("div", {});
  const show = () => {
    const takes = store.get(TAKES).map(({ id, name }) => /** @type {const} */ ([id, name]));
    const other = choice([...VERSIONS, ...takes], store.get(COMPARED), (version) => store.set(COMPARED, version));
    other.id = "compare-with";
    redraw(element, [labelled("Compare this line with", other)]);
  };
  for (const of of [TAKES, COMPARED]) {
    store.watch(/** @type {typeof COMPARED} */ (of), show);
  }
  return element;
}

/**
 * @param {Store} store
 * @param {Take} take
 */
function entry(store, take) {
  const isNow = takeOf([take], draftOf(store.get(PROJECT))) !== undefined;
  const isBeside = store.get(COMPARED) === take.id;
  const { options, edits } = take.draft;
  const changes = /** @type {Edits | null} */ (edits)?.behaviors?.length ?? 0;
  const told = [changes ? `${String(changes)} ${changes > 1 ? "edits" : "edit"}` : "", isNow ? "edited now" : ""].filter(Boolean).join(", ");
  const button = (/** @type {string} */ text, /** @type {() => void} */ click, /** @type {Record<string, string | boolean>} */ attributes = {}) =>
    el("button", { type: "button", click, ...attributes }, [text]);
  return el("li", {}, [
    el("span", { title: `seed ${String(options.seed ?? 0)}` }, [el("b", {}, [take.name]), ` ${told}`]),
    button("Use this one", () => useTake(store, take), { disabled: isNow, title: "Makes it the line that you edit", "aria-label": `Use this one: ${take.name}` }),
    button("Compare", () => store.set(COMPARED, isBeside ? "none" : take.id), { "aria-pressed": String(isBeside), "aria-label": `Compare with ${take.name}` }),
    button("✕", () => forgetTake(store, take), { class: "quiet square", "aria-label": `Forget ${take.name}` }),
  ]);
}

/** @param {Store} store */
function toldOf(store) {
  const differs = store.get(DIFFERS);
  return differs ? toldDifferences(differs.found) : "";
}

/** @param {Store} store */
function differing(store) {
  const differs = store.get(DIFFERS);
  if (!differs) {
    return [];
  }
  const { here, there } = differs.found;
  const entry = (/** @type {string} */ whose, /** @type {Behavior} */ behavior, /** @type {() => void} */ click) =>
    el("li", {}, [`${whose}: `, el("button", { type: "button", class: "link", click }, [said(behavior)])]);
  return [
    ...here.map((behavior) => entry("This line", behavior, () => selectAndSeek(store, behavior.id))),
    ...there.map((behavior) => entry(nameOf(store) ?? "", behavior, () => seekTo(store, behavior))),
  ];
}

/** @param {Behavior} behavior */
function said({ kind, lexeme, sync }) {
  return `${movementName(kind, lexeme)}, ${(sync["start"] ?? 0).toFixed(2)} s`;
}
