/** Where answers are kept between two visits: in the browser, or, where it keeps nothing for this page, in the page alone. */

/** @import { Store } from "./answers.js" */

/** @returns {{ store: Store, lasts: boolean }} */
export function keeping() {
  try {
    localStorage.setItem("study", "kept");
    return { store: localStorage, lasts: true };
  } catch {
    return { store: inThePage(), lasts: false };
  }
}

/** @returns {Store} */
function inThePage() {
  /** @type {Map<string, string>} */
  const texts = new Map();
  return { getItem: (name) => texts.get(name) ?? null, setItem: (name, text) => void texts.set(name, text) };
}
