/** Light or dark: as the system has it, unless the author says otherwise. */

import { choice, labelled } from "../dom.js";

const KEY = "understudy-theme";

/** @param {HTMLElement} element */
export function mountPreferences(element) {
  const kept = localStorage.getItem(KEY) ?? "system";
  const show = (/** @type {string} */ theme) => {
    document.documentElement.dataset["theme"] = theme;
    localStorage.setItem(KEY, theme);
  };
  const themes = /** @type {const} */ ([["system", "As the system"], ["light", "Light"], ["dark", "Dark"]]);
  element.append(labelled("Colours", choice(themes, kept, show)));
  show(kept);
}
