/** The lines of a scene in time, one after the other. */

/** @typedef {Readonly<{ start_s: number, end_s: number }>} Span when a line is spoken, on the scene's clock */

/** Between two lines. */
export const PAUSE_S = 0.4;

/**
 * @param {readonly { duration_s: number }[]} lines
 * @returns {Span[]}
 */
export function spansOf(lines) {
  let start_s = 0;
  return lines.map(({ duration_s }) => {
    const span = { start_s, end_s: start_s + duration_s };
    start_s = span.end_s + PAUSE_S;
    return span;
  });
}

/**
 * The place of the line that is spoken at a time, or was the last to be.
 *
 * @param {readonly Span[]} spans
 * @param {number} time_s
 */
export function lineAt(spans, time_s) {
  const later = spans.findIndex(({ start_s }) => start_s > time_s);
  return later < 0 ? spans.length - 1 : Math.max(0, later - 1);
}
