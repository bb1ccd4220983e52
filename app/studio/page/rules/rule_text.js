/** The file of a rule or word, to be edited: checked while it is written, with every mistake at its line and column. */

import { el, readOut } from "../dom.js";
import { plain } from "../naming/movements.js";
import { latest } from "../service/latest.js";
import { PERFORMED } from "../state/performed.js";
import { goTo } from "../text_place.js";
import { CHOSEN, DRAFTS, FILES, IN_USE, ITEMS, loadText, MISTAKES, OTHERS, posted, told } from "./rule_book.js";
import { actions } from "./trying.js";

/** @import { Performance, PlacedMistake, RuleMistakes } from "understudy-client" */
/** @import { Service } from "../service/service.js" */
/** @import { Store } from "../state/store.js" */

const QUIET_MS = 400;

/**
 * @param {Store} store
 * @param {Service} service
 */
export function ruleText(store, service) {
  const title = el("h2", { id: "rule-file" }, ["Choose a rule or a word"]);
  const typed = el("textarea", { id: "rule-text", spellcheck: false, wrap: "off", "aria-labelledby": "rule-file", disabled: true });
  const mistakes = el("ul", { id: "rule-mistakes", class: "mistakes" });
  store.watch(CHOSEN, (item) => {
    if (item) {
      void show(store, service, { title, typed });
    }
  });
  store.watch(MISTAKES, (found) => mistakes.replaceChildren(...found.map((mistake) => wrong(store, typed, mistake))));
  store.watch(DRAFTS, (drafts) => {
    const name = store.get(CHOSEN)?.file;
    const text = name === undefined ? undefined : (drafts[name] ?? store.get(IN_USE)[name]);
    if (text !== undefined && typed.value !== text && !typed.disabled) {
      typed.value = text;
    }
  });
  keepChecked(store, service, typed);
  const begin = beginnings(store);
  store.watch(CHOSEN, (item) => (begin.hidden = item !== null));
  return el("section", { class: "rule-text", "aria-label": "File" }, [title, begin, typed, readOut(mistakes), actions(store, service)]);
}

/**
 * Where to begin before a rule is chosen: the rules by which the open line is performed.
 *
 * @param {Store} store
 */
function beginnings(store) {
  const list = el("ul", { class: "beginnings" });
  const hint = el("p", { class: "quiet" });
  const show = () => {
    const used = rulesOf(store.get(PERFORMED)?.performance);
    const found = used.flatMap((name) => store.get(ITEMS).find((item) => item.name === name) ?? []);
    hint.textContent = found.length > 0 ? "Its file is edited here. The open line uses these:" : "Search on the left for a word, a meaning or a movement. Its file is edited here.";
    list.replaceChildren(...found.map((item) => el("li", {}, [el("button", { type: "button", title: item.name, click: () => store.set(CHOSEN, item) }, [plain(item.name)])])));
  };
  store.watch(ITEMS, show);
  store.watch(PERFORMED, show);
  return el("div", { class: "none" }, [hint, list]);
}

/**
 * The rules that found what a line means, in the order of its words.
 *
 * @param {Performance | undefined} performance
 */
export function rulesOf(performance) {
  return [...new Set(performance?.functions.filter(({ kept }) => kept).map(({ rule }) => rule))];
}

/**
 * @param {Store} store
 * @param {Service} service
 * @param {{ title: HTMLElement, typed: HTMLTextAreaElement }} shown
 */
async function show(store, service, { title, typed }) {
  const item = store.get(CHOSEN);
  if (!item) {
    return;
  }
  const { file, line } = item;
  const isEditable = [...store.get(FILES).files, ...store.get(OTHERS).files].includes(file);
  const place = `${file}:${String(line)}${isEditable ? "" : " (not edited here)"}`;
  title.replaceChildren(plain(item.name), el("span", { class: "place" }, [place]));
  if (!isEditable) {
    typed.value = "";
    typed.disabled = true;
    return;
  }
  typed.readOnly = true;
  await loadText(store, service, file);
  if (store.get(CHOSEN) === item) {
    typed.disabled = typed.readOnly = false;
    typed.value = store.get(DRAFTS)[file] ?? store.get(IN_USE)[file] ?? "";
    goTo(typed, { line, column: 1 });
    typed.scrollTop = (line - 3) * (typed.scrollHeight / (typed.value.split("\n").length || 1));
  }
}

/**
 * @param {Store} store
 * @param {Service} service
 * @param {HTMLTextAreaElement} typed
 */
function keepChecked(store, service, typed) {
  let timer = 0;
  const check = latest(() =>
    told(store, async () => {
      const files = store.get(DRAFTS);
      const found = /** @type {RuleMistakes} */ (await posted(service, "rules/check", { files }));
      store.set(MISTAKES, found.mistakes);
    }),
  );
  typed.addEventListener("input", () => {
    const name = store.get(CHOSEN)?.file;
    if (name !== undefined) {
      store.set(DRAFTS, withDraft(store.get(DRAFTS), name, typed.value, store.get(IN_USE)[name]));
      clearTimeout(timer);
      timer = window.setTimeout(() => void check(), QUIET_MS);
    }
  });
}

/**
 * The drafts with a file's text; a text that is in use is no draft.
 *
 * @param {Readonly<Record<string, string>>} drafts
 * @param {string} name
 * @param {string} text
 * @param {string | undefined} inUse
 */
export function withDraft(drafts, name, text, inUse) {
  const others = Object.entries(drafts).filter(([other]) => other !== name);
  return Object.fromEntries(text === inUse ? others : [...others, [name, text]]);
}

/**
 * @param {Store} store
 * @param {HTMLTextAreaElement} typed
 * @param {PlacedMistake} mistake
 */
function wrong(store, typed, mistake) {
  const file = mistake.file ?? "";
  const place = `${file}:${String(mistake.line)}:${String(mistake.column)}`;
  const isHere = store.get(CHOSEN)?.file === file;
  const go = () => {
    if (isHere) {
      goTo(typed, mistake);
    } else {
      store.set(CHOSEN, { kind: "function", name: file, file, line: mistake.line });
    }
  };
  return el("li", { class: "wrong" }, [el("button", { type: "button", class: "link", click: go }, [place]), ` ${mistake.message}`]);
}
