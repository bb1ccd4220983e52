/** What is done with edited rules: the line performed by them, all example lines compared, taken back, saved. */

import { el } from "../dom.js";
import { VIEW } from "../frame/views.js";
import { ChangeProject } from "../state/change_project.js";
import { PROJECT } from "../state/project.js";
import { saveFile } from "../service/files.js";
import { CHOSEN, COMPARED, DRAFTS, FILES, MISTAKES, pathOf, posted, ruleDrafts, told, TRYING } from "./rule_book.js";

/** @import { RuleComparison } from "understudy-client" */
/** @import { Service } from "../service/service.js" */
/** @import { Store } from "../state/store.js" */

const HINTS = Object.freeze({
  "rules-run": "Performs the line that is open by these rules",
  "rules-compare": "What your changes do to this line, and to an example line of every rule",
  "rules-back": "Discards your changes to this file",
  "rules-save": "Saves the file into the author's folder",
});

/** The line that is open, among the lines that are compared. */
export const THIS_LINE = "this line";

/**
 * @param {Store} store
 * @param {Service} service
 */
export function actions(store, service) {
  const button = (/** @type {keyof typeof HINTS} */ id, /** @type {string} */ text, /** @type {() => void} */ click) =>
    el("button", { type: "button", id, class: id === "rules-run" ? "primary" : "", title: HINTS[id], click }, [text]);
  const run = button("rules-run", "Perform the line", () => perform(store));
  const compare = button("rules-compare", "See what changes", () => void compareAll(store, service));
  const back = button("rules-back", "Discard changes", () => takeBack(store));
  const save = button("rules-save", "Save", () => void keep(store, service));
  const bar = el("div", { class: "row", role: "toolbar", "aria-label": "Try the rules" }, [run, compare, back, save]);
  const show = () => {
    const drafts = store.get(DRAFTS);
    const isWrong = store.get(MISTAKES).length > 0;
    const file = store.get(CHOSEN)?.file ?? "";
    run.disabled = isWrong;
    compare.disabled = store.get(TRYING) || isWrong || Object.keys(ruleDrafts(store)).length === 0;
    compare.textContent = store.get(TRYING) ? "Reading the examples…" : "See what changes";
    back.disabled = !(file in drafts);
    save.hidden = !store.get(FILES).writable;
    save.disabled = isWrong || !(file in drafts);
    bar.hidden = file === "" && Object.keys(drafts).length === 0;
  };
  for (const of of [DRAFTS, MISTAKES, CHOSEN, FILES, TRYING]) {
    store.watch(/** @type {typeof FILES} */ (of), show);
  }
  return bar;
}

/**
 * Performs the line by the drafts: they are part of the project, so that it can be undone.
 *
 * @param {Store} store
 */
function perform(store) {
  const drafts = ruleDrafts(store);
  const rules = Object.keys(drafts).length > 0 ? drafts : null;
  store.history.execute(new ChangeProject(store, "Rules", { rules }));
  store.set(VIEW, "line");
}

/**
 * @param {Store} store
 * @param {Service} service
 */
async function compareAll(store, service) {
  const { text } = store.get(PROJECT);
  const lines = text.trim() ? { [THIS_LINE]: text } : {};
  store.set(TRYING, true);
  await told(store, async () => {
    const found = await posted(service, "rules/compare", { files: ruleDrafts(store), lines });
    store.set(COMPARED, /** @type {RuleComparison} */ (found));
  });
  store.set(TRYING, false);
}

/** @param {Store} store */
function takeBack(store) {
  const file = store.get(CHOSEN)?.file;
  const others = Object.entries(store.get(DRAFTS)).filter(([name]) => name !== file);
  store.set(DRAFTS, Object.fromEntries(others));
  store.set(MISTAKES, store.get(MISTAKES).filter((mistake) => mistake.file !== file));
  store.set(COMPARED, null);
}

/**
 * @param {Store} store
 * @param {Service} service
 */
async function keep(store, service) {
  const name = store.get(CHOSEN)?.file ?? "";
  const text = store.get(DRAFTS)[name];
  if (text !== undefined) {
    await told(store, async () => {
      await saveFile(service, pathOf(store, name), text);
      store.patch(FILES, { saved: [...new Set([...store.get(FILES).saved, name])] });
    });
  }
}
