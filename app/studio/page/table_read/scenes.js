/** The scenes of a script, and the colours of those who speak in it. */

/** @import { SceneLine } from "./scene_index.js" */

/** The lines of a scene by their places; `name` is empty where a script has one scene. @typedef {Readonly<{ name: string, places: readonly number[] }>} Scene */

const NUMBERED = /^(.*?)[_\-. ]*\d+$/;
const COUNT = 6;

/**
 * Lines by scenes, in which a batch numbers them: `scene2_014` is the fourteenth of scene 2.
 *
 * @param {readonly Pick<SceneLine, "id">[]} lines
 * @returns {Scene[]}
 */
export function scenesOf(lines) {
  /** @type {{ name: string, places: number[] }[]} */
  const scenes = [];
  for (const [place, { id }] of lines.entries()) {
    const name = nameOf(id);
    const last = scenes.at(-1);
    if (last?.name === name) {
      last.places.push(place);
    } else {
      scenes.push({ name, places: [place] });
    }
  }
  const names = new Set(scenes.map(({ name }) => name));
  return names.size > 1 ? scenes : [{ name: "", places: lines.map((_, place) => place) }];
}

/** @param {string} id */
function nameOf(id) {
  const name = (NUMBERED.exec(id)?.[1] ?? "").replace(/^scene[_ ]?(?=.)/i, "Scene ").replaceAll("_", " ");
  return name.charAt(0).toUpperCase() + name.slice(1);
}

/**
 * The number of somebody's colour (`--cast-1` and so on), by when he comes in.
 *
 * @param {readonly string[]} cast
 * @param {string} name
 */
export function colourOf(cast, name) {
  return 1 + (Math.max(0, cast.indexOf(name)) % COUNT);
}
