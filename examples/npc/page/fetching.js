/** Asks the game server for JSON. */

/**
 * @param {string} path
 * @returns {Promise<any>}
 */
export async function fetched(path) {
  const answer = await fetch(path);
  const content = await answer.json();
  if (!answer.ok) {
    throw new Error(content.detail);
  }
  return content;
}
