/** Notes on the lines of scenes, as a director makes them: kept in this browser, and saved as a list. */

const KEY = "understudy-notes";

/** Notes by script and line. @returns {Record<string, string>} */
function all() {
  return JSON.parse(localStorage.getItem(KEY) ?? "{}");
}

/**
 * @param {string} script
 * @param {string} id of the line
 */
export function noteOn(script, id) {
  return all()[`${script} ${id}`] ?? "";
}

/**
 * @param {string} script
 * @param {string} id
 * @param {string} note empty for none
 */
export function takeNote(script, id, note) {
  const others = Object.entries(all()).filter(([key]) => key !== `${script} ${id}`);
  localStorage.setItem(KEY, JSON.stringify(Object.fromEntries(note ? [...others, [`${script} ${id}`, note]] : others)));
}

/**
 * The notes of a script as text, a line each.
 *
 * @param {string} script
 * @param {readonly Readonly<{ id: string, speaker: string }>[]} lines
 */
export function notesText(script, lines) {
  const noted = lines.flatMap(({ id, speaker }) => (noteOn(script, id) ? [`${id}\t${speaker}\t${noteOn(script, id)}`] : []));
  return `${noted.join("\n")}\n`;
}
