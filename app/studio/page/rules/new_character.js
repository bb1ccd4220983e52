/** A new character: a file of its own in the author's folder, which begins as a copy of another one's. */

import { choice, el, labelled } from "../dom.js";
import { readFile } from "../service/files.js";
import { plain } from "../naming/movements.js";
import { CHOSEN, DRAFTS, itemOf, ITEMS, loadText, OTHERS, told } from "./rule_book.js";

/** @import { Service } from "../service/service.js" */
/** @import { Store } from "../state/store.js" */

const FOLDER = "lexicon/characters/";
/** What the service takes as the name of a file. */
const NAME = "[A-Za-z0-9][A-Za-z0-9_\\-]*";

/**
 * Where its name is typed; only where characters can be saved.
 *
 * @param {Store} store
 * @param {Service} service
 */
export function newCharacter(store, service) {
  const name = el("input", { id: "character-name", required: true, pattern: NAME, placeholder: "old_sailor", autocomplete: "off", spellcheck: false, title: "Letters, figures, _ and -" });
  const like = el("div", {});
  const submit = (/** @type {Event} */ event) => {
    event.preventDefault();
    const model = like.querySelector("select")?.value ?? "";
    void told(store, () => make(store, service, name.value, model)).then(() => form.reset());
  };
  const form = el("form", { submit }, [labelled("Name", name), like, el("button", { id: "character-make" }, ["Make"])]);
  const fold = el("details", { class: "part new-character" }, [el("summary", {}, ["New character…"]), form]);
  store.watch(OTHERS, ({ writable, files }) => {
    const known = files.filter((file) => file.startsWith(FOLDER)).map((file) => /** @type {const} */ ([file, plain(itemOf(file).name)]));
    fold.hidden = !writable;
    like.replaceChildren(labelled("Begins like", choice(known, `${FOLDER}default.yaml`, () => undefined)));
  });
  return fold;
}

/**
 * Shows the new file with the other's text; it is not saved before its author does. Of a name that there is, the file is shown.
 *
 * @param {Store} store
 * @param {Service} service
 * @param {string} name
 * @param {string} model the file that it begins like
 */
async function make(store, service, name, model) {
  const file = `${FOLDER}${name}.yaml`;
  const known = store.get(ITEMS).find((item) => item.file === file);
  if (!known) {
    const { text } = await readFile(service, `lexicon/files/${model}`);
    const others = store.get(OTHERS);
    store.set(OTHERS, { ...others, files: [...others.files, file] });
    store.set(ITEMS, [...store.get(ITEMS), itemOf(file)]);
    await loadText(store, service, file);
    store.patch(DRAFTS, { [file]: text });
  }
  store.set(CHOSEN, known ?? itemOf(file));
}
