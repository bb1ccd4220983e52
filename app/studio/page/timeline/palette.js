/** The page's colours for the canvas, which cannot take them from style sheets by itself. */

/**
 * @typedef {Record<"panel" | "ink" | "quiet" | "faint" | "focus" | "differs" | "wave" | "f0" | "energy" | "stress", string> &
 *   { rows: Readonly<Record<string, string>> }} Palette
 */

const NAMES = /** @type {const} */ (["panel", "ink", "quiet", "faint", "focus", "differs", "wave", "f0", "energy", "stress"]);
const ROWS = ["functions", "feeling", "focus", "gesture", "head", "gaze", "face", "eyes", "posture", "compared"];

/**
 * @param {Element} element
 * @returns {Palette}
 */
export function paletteOf(element) {
  const style = getComputedStyle(element);
  const colour = (/** @type {string} */ name) => style.getPropertyValue(`--${name}`).trim();
  const own = /** @type {Record<typeof NAMES[number], string>} */ (Object.fromEntries(NAMES.map((name) => [name, colour(name)])));
  return { ...own, rows: Object.fromEntries(ROWS.map((name) => [name, colour(`row-${name}`)])) };
}
