/** The lines that were worked on last, on the start page: a press opens one as it was. */

import { el } from "../dom.js";
import { projects, remove } from "./shelf.js";

/** @import { KeptProject } from "./shelf.js" */

/** How many are listed before somebody asks for all. */
const SHOWN = 6;

/**
 * A list of the lines that are kept, filled by `show()`.
 *
 * @param {(project: KeptProject) => void} open
 */
export function recentLines(open) {
  const list = el("ul", { class: "recent" });
  const all = el("button", { type: "button", id: "recent-all", class: "quiet" });
  const element = el("div", { id: "recent", hidden: true }, [el("h3", {}, ["Recent"]), list, all]);
  let most = SHOWN;
  all.addEventListener("click", () => {
    most = Infinity;
    void show();
  });
  const show = async () => {
    // Where the browser keeps nothing there is nothing to list.
    const found = await projects().catch(() => []);
    element.hidden = found.length === 0;
    all.hidden = found.length <= most;
    all.textContent = `All ${String(found.length)} lines`;
    list.replaceChildren(...found.slice(0, most).map((project) => entry(project, open, () => void show())));
  };
  return { element, show };
}

/**
 * @param {KeptProject} project
 * @param {(project: KeptProject) => void} open
 * @param {() => void} changed
 */
function entry(project, open, changed) {
  const { audio, draft, takes, saved_ms } = project;
  const told = [new Date(saved_ms).toLocaleString([], { dateStyle: "medium", timeStyle: "short" }), toldTakes(takes.length)].filter(Boolean).join(" · ");
  const forget = () => void remove(project.id).then(changed);
  return el("li", {}, [
    el("button", { type: "button", class: "open", click: () => open(project) }, [
      el("b", {}, [audio.name]),
      el("span", {}, [draft.text]),
      el("span", {}, [told]),
    ]),
    el("button", { type: "button", class: "quiet square remove", "aria-label": `Forget ${audio.name}`, title: "Forget it", click: forget }, ["✕"]),
  ]);
}

/** @param {number} count */
function toldTakes(count) {
  return count === 0 ? "" : `${String(count)} take${count === 1 ? "" : "s"}`;
}
