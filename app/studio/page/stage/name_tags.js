/** The names above the heads of those who stand on the stage, where there are several. */

import { el } from "../dom.js";

/** @import { PerspectiveCamera } from "three" */
/** @import { Standing } from "./cast.js" */
/** @import { Figure } from "./figure.js" */

/** Whom a tag is on; `edited` for the version that is changed. @typedef {Readonly<{ name: string, edited: boolean, figure: Figure }>} Named */

const ABOVE_M = 0.32;

export class NameTags {
  element = el("div", { class: "name-tags" });

  /**
   * @param {readonly Named[]} named
   * @param {PerspectiveCamera} camera
   */
  show(named, camera) {
    const tags = named.flatMap(({ name, edited, figure }) => {
      const place = figure.place("head");
      if (!place) {
        return [];
      }
      const { x, y } = place.setY(place.y + ABOVE_M).project(camera);
      const tag = el("span", { class: edited ? "name-tag edited" : "name-tag" }, [name]);
      tag.style.left = `${String(50 + 50 * x)}%`;
      tag.style.top = `max(var(--control), ${String(50 - 50 * y)}%)`;
      return [tag];
    });
    this.element.replaceChildren(...tags);
  }
}

/**
 * Whom tags are on: nobody unless a version is compared, which has a name.
 *
 * @param {readonly Standing[]} standing
 * @param {string} compared
 * @returns {Named[]}
 */
export function namedOf(standing, compared) {
  const isCompared = standing.some(({ role }) => role.name === "compared");
  return (isCompared ? standing : []).map(({ role, figure }) => {
    const edited = role.name === "speaker";
    return { name: edited ? "This line, edited" : role.name === "compared" ? compared : role.name, edited, figure };
  });
}
