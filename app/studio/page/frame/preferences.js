/** Light or dark: as the system has it, unless the author says otherwise. */

import { choice, el } from "../dom.js";
import { icon } from "../icons.js";

const KEY = "understudy-theme";

/** @param {HTMLElement} element */
export function mountPreferences(element) {
  const kept = localStorage.getItem(KEY) ?? "system";
  const show = (/** @type {string} */ theme) => {
    document.documentElement.dataset["theme"] = theme;
    localStorage.setItem(KEY, theme);
  };
  const themes = /** @type {const} */ ([["system", "System"], ["light", "Light"], ["dark", "Dark"]]);
  const chosen = choice(themes, kept, show);
  chosen.setAttribute("aria-label", "Theme");
  element.append(el("span", { class: "with-icon", title: "Theme" }, [icon("theme"), chosen]));
  show(kept);
}
