/** The names of those who stand on the stage, where there are several: all in one row above the heads, or below where there is no room. */

import { el } from "../dom.js";

import { LISTENER } from "./viewing.js";

/** @import { PerspectiveCamera } from "three" */
/** @import { Standing } from "./cast.js" */
/** @import { Figure } from "./figure.js" */

/** Whom a tag is on; `edited` for the version that is changed. @typedef {Readonly<{ name: string, edited: boolean, figure: Figure }>} Named */

const ABOVE_M = 0.26;
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
    const places = named.flatMap(({ figure, ...each }) => {
      const place = figure.place("head");
      return place ? [{ ...each, at: place.setY(place.y + ABOVE_M).project(camera) }] : [];
    });
    const top = Math.min(...places.map(({ at }) => 0.5 - 0.5 * at.y));
    const isRoom = top * height_px >= LEAST_ROOM_PX;
    const row = isRoom ? `max(var(--control), ${String(100 * top)}%)` : "calc(100% - .2rem)";
    this.element.replaceChildren(...places.map((each) => tagOf(each, row)));
  }
}

/**
 * A name as far along its row as its body is, and never over the edge of the stage: at the left edge it begins there, at the
 * right one it ends there.
 *
 * @param {Readonly<{ name: string, edited: boolean, at: Readonly<{ x: number }> }>} named
 * @param {string} top
 */
function tagOf({ name, edited, at }, top) {
  const tag = el("span", { class: edited ? "name-tag edited" : "name-tag" }, [name]);
  const along = `${String(Math.min(100, Math.max(0, 50 + 50 * at.x)))}%`;
  tag.style.left = along;
  tag.style.top = top;
  tag.style.transform = `translate(-${along}, -100%)`;
  return tag;
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
    return { name: edited ? "This line, edited" : role.name === "compared" ? compared : role.name === LISTENER ? "Listener" : role.name, edited, figure };
  });
}
