/** Loads what lies beside the page, from a web server or from a disk, where browsers load nothing but scripts. */

/** @type {Map<string, Promise<string>>} */
const asked = new Map();

/**
 * The content of a file, loaded once. Rejects where there is none.
 *
 * @param {string} name
 * @returns {Promise<string>}
 */
export function fileNamed(name) {
  const found = asked.get(name) ?? loaded(name);
  asked.set(name, found);
  found.catch(() => asked.delete(name));
  return found;
}

/**
 * @param {string} name
 * @returns {Promise<string>}
 */
function loaded(name) {
  return new Promise((resolve, reject) => {
    const script = document.createElement("script");
    const take = (/** @type {Event} */ event) => {
      const { detail } = /** @type {CustomEvent<{ name: string, content: string }>} */ (event);
      if (detail.name === name) {
        removeEventListener("study-file", take);
        script.remove();
        resolve(detail.content);
      }
    };
    addEventListener("study-file", take);
    script.src = `clips/${name}.js`;
    script.onerror = () => reject(new Error(`clips/${name}.js is missing beside the page`));
    document.head.append(script);
  });
}
