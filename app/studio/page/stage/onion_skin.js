/** Onion skin: the speaker as he stands at the strokes before and after the playhead, faint, on demand. */

import { Color, Group, Mesh, MeshBasicMaterial } from "three";

import { playedSync } from "../timeline/phases.js";
import { Figure } from "./figure.js";

/** @import { Behavior, Clip } from "understudy-client" */
/** @import { Object3D } from "three" */
/** @import { Bodies } from "./bodies.js" */

const [BEFORE, AFTER] = [new Color("#2f6fd0"), new Color("#d9772b")];
const OPACITY = 0.3;
/** A stroke as near as that is the one that is seen on the body itself. */
const NEAR_S = 0.02;

/** An object for the scene; `show` says of which time. */
export class OnionSkin {
  group = new Group();
  #strokes_s = /** @type {readonly number[]} */ ([]);
  #clip = /** @type {Clip | null} */ (null);
  #shown = "";
  #latest = 0;
  /** That of before, and that of after. @type {readonly Figure[]} */
  #figures = [];
  #character = "";

  /**
   * Takes over the strokes of a clip's gestures. Rejects where the body cannot be had.
   *
   * @param {Bodies} bodies
   * @param {string} character
   * @param {Readonly<{ clip: Clip, behaviors: readonly Behavior[] }>} performed
   */
  async take(bodies, character, { clip, behaviors }) {
    const turn = ++this.#latest;
    const roots = this.#character === character ? [] : await Promise.all([bodies.mannequin(character), bodies.mannequin(character)]);
    if (turn !== this.#latest) {
      return;
    }
    if (roots.length > 0) {
      this.clear();
      this.#figures = roots.map((body) => new Figure(body, clip.joints));
      roots.forEach(({ root }, place) => paint(root, place === 0 ? BEFORE : AFTER));
      this.group.add(...roots.map(({ root }) => root));
      this.#character = character;
    }
    this.#clip = clip;
    this.#strokes_s = strokesOf(clip, behaviors);
    this.#shown = "";
  }

  /** @param {number} time_s after the clip's first frame */
  show(time_s) {
    const clip = this.#clip;
    const around_s = strokesAround(this.#strokes_s, time_s);
    if (clip && String(around_s) !== this.#shown) {
      this.#shown = String(around_s);
      this.#figures.forEach((figure, place) => {
        const stroke_s = around_s[place] ?? null;
        figure.root.visible = stroke_s !== null;
        if (stroke_s !== null) {
          figure.show(clip, stroke_s);
        }
      });
    }
  }

  clear() {
    this.#latest += 1;
    this.group.clear();
    [this.#figures, this.#character, this.#clip, this.#shown] = [[], "", null, ""];
  }
}

/**
 * When the gestures of a clip have their strokes, in order.
 *
 * @param {Clip} clip
 * @param {readonly Behavior[]} behaviors
 */
function strokesOf(clip, behaviors) {
  return behaviors
    .filter(({ kept, kind }) => kept && kind === "gesture")
    .flatMap(({ id }) => playedSync(clip.events, id)["stroke"] ?? [])
    .sort((one, other) => one - other);
}

/**
 * The last stroke before a time, and the first after it; null where there is none.
 *
 * @param {readonly number[]} strokes_s in order
 * @param {number} time_s
 * @returns {readonly [number | null, number | null]}
 */
export function strokesAround(strokes_s, time_s) {
  const before = strokes_s.filter((each) => each < time_s - NEAR_S).at(-1) ?? null;
  return [before, strokes_s.find((each) => each > time_s + NEAR_S) ?? null];
}

/**
 * @param {Object3D} root
 * @param {Color} color
 */
function paint(root, color) {
  const faint = new MeshBasicMaterial({ color, transparent: true, opacity: OPACITY });
  root.traverse((object) => {
    if (object instanceof Mesh) {
      object.material = faint;
      object.castShadow = false;
    }
  });
}
