/** The names above the heads of those who stand on the stage, where there are several; below them where there is no room. */

import { el } from "../dom.js";

/** @import { PerspectiveCamera } from "three" */
/** @import { Standing } from "./cast.js" */
/** @import { Figure } from "./figure.js" */

/** Whom a tag is on; `edited` for the version that is changed. @typedef {Readonly<{ name: string, edited: boolean, figure: Figure }>} Named */

const ABOVE_M = 0.32;
/** With less room than this above a head its name would hide the face. */
const LEAST_ROOM_PX = 18;

export class NameTags {
  element = el("div", { class: "name-tags" });

  /**
   * @param {readonly Named[]} named
   * @param {PerspectiveCamera} camera
   */
  show(named, camera) {
    const height_px = named.length > 0 ? (this.element.parentElement?.clientHeight ?? 0) : 0;
    const tags = named.flatMap(({ name, edited, figure }) => {
      const place = figure.place("head");
      if (!place) {
        return [];
      }
      const { x, y } = place.setY(place.y + ABOVE_M).project(camera);
      const tag = el("span", { class: edited ? "name-tag edited" : "name-tag" }, [name]);
      tag.style.left = `${String(50 + 50 * x)}%`;
      const isRoom = (0.5 - 0.5 * y) * height_px >= LEAST_ROOM_PX;
      tag.style.top = isRoom ? `max(var(--control), ${String(50 - 50 * y)}%)` : "calc(100% - .2rem)";
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
