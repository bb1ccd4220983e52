/** Puts the cursor where something is told of a text. */

/**
 * @param {HTMLTextAreaElement} typed
 * @param {Readonly<{ line: number, column: number }>} place both count from 1
 */
export function goTo(typed, { line, column }) {
  const before = typed.value.split("\n").slice(0, line - 1);
  const start = before.reduce((sum, each) => sum + each.length + 1, 0) + column - 1;
  typed.focus();
  typed.setSelectionRange(start, start + 1);
}
