/** The gestures that an author marked or chose last, kept in this browser. */

const [FAVOURITES, RECENT] = ["understudy-favourite-gestures", "understudy-recent-gestures"];
const MOST_RECENT = 8;

/** @returns {readonly string[]} lexemes */
export function favourites() {
  return read(FAVOURITES);
}

/** The gestures that were chosen last, the latest first. @returns {readonly string[]} */
export function recent() {
  return read(RECENT);
}

/**
 * Marks a gesture, or no longer; whether it is marked now.
 *
 * @param {string} lexeme
 */
export function toggleFavourite(lexeme) {
  const before = favourites();
  const isMarked = !before.includes(lexeme);
  write(FAVOURITES, isMarked ? [...before, lexeme] : before.filter((each) => each !== lexeme));
  return isMarked;
}

/** @param {string} lexeme */
export function remember(lexeme) {
  write(RECENT, [lexeme, ...recent().filter((each) => each !== lexeme)].slice(0, MOST_RECENT));
}

/** @param {string} key */
function read(key) {
  return /** @type {string[]} */ (JSON.parse(localStorage.getItem(key) ?? "[]"));
}

/**
 * @param {string} key
 * @param {readonly string[]} lexemes
 */
function write(key, lexemes) {
  localStorage.setItem(key, JSON.stringify(lexemes));
}
