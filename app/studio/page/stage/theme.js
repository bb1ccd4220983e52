/** The room has the colours of the page, light or dark. */

/** @import { Place } from "./scene.js" */

/**
 * @param {Place} place
 * @param {() => void} changed is called when it has others
 */
export function followTheme(place, changed) {
  const paint = () => {
    const style = getComputedStyle(document.documentElement);
    const colour = (/** @type {string} */ name) => style.getPropertyValue(name).trim();
    place.paint({ stage: colour("--stage"), grid: colour("--stage-grid") });
    changed();
  };
  new MutationObserver(paint).observe(document.documentElement, { attributeFilter: ["data-theme"] });
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", paint);
  paint();
}
