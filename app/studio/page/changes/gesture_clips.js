/** The motion of single gestures for their thumbnails: the service plays each on our body the first time that it is seen. */

import { clipFromJson } from "understudy-client";

/** @import { Clip } from "understudy-client" */
/** @import { Service } from "../service/service.js" */

const START_S = 0.2;

/** Clips of gestures by lexeme, each asked for once and one after the other: the line itself is not to wait for them. */
export class GestureClips {
  /** @type {Map<string, Promise<Clip>>} */
  #clips = new Map();
  /** @type {Promise<unknown>} */
  #last = Promise.resolve();
  /** Whether somebody who asked for a gesture still wants it, by lexeme. @type {Map<string, (() => boolean)[]>} */
  #wanted = new Map();
  #service;

  /** @param {Service} service */
  constructor(service) {
    this.#service = service;
  }

  /**
   * Rejects where the service does not play it, or nobody wants it any more when its turn comes.
   *
   * @param {string} lexeme
   * @param {() => boolean} isWanted
   * @returns {Promise<Clip>}
   */
  of(lexeme, isWanted) {
    const known = this.#clips.get(lexeme);
    this.#wanted.set(lexeme, [...(this.#wanted.get(lexeme) ?? []), isWanted]);
    if (known) {
      return known;
    }
    const asked = this.#last.then(() => this.#inTurn(lexeme));
    this.#clips.set(lexeme, asked);
    this.#last = asked.catch(() => this.#clips.delete(lexeme));
    return asked;
  }

  /** @param {string} lexeme */
  #inTurn(lexeme) {
    const isWanted = this.#wanted.get(lexeme)?.some((each) => each());
    this.#wanted.delete(lexeme);
    return isWanted ? this.#asked(lexeme) : Promise.reject(new Error("nobody wants it"));
  }

  /** @param {string} lexeme */
  async #asked(lexeme) {
    const form = new FormData();
    form.append("bml", new Blob([played(lexeme)], { type: "application/xml" }), "gesture.bml");
    form.append("options", JSON.stringify({ fps: 30, stillness: 0 }));
    const answer = await this.#service.fetch("realize", { method: "POST", headers: { accept: "application/json" }, body: form });
    return clipFromJson(await answer.json());
  }
}

/** Clips stay for the next time, as long as the service is the same. @type {WeakMap<Service, GestureClips>} */
const CLIPS = new WeakMap();

/** @param {Service} service */
export function clipsOf(service) {
  const clips = CLIPS.get(service) ?? new GestureClips(service);
  CLIPS.set(service, clips);
  return clips;
}

/** @param {string} lexeme */
function played(lexeme) {
  const root = document.implementation.createDocument("http://www.bml-initiative.org/bml/bml-1.0", "bml");
  const gesture = root.createElementNS(root.documentElement.namespaceURI, "gesture");
  root.documentElement.setAttribute("id", "shown");
  for (const [name, value] of Object.entries({ id: "gesture", lexeme, start: String(START_S) })) {
    gesture.setAttribute(name, value);
  }
  root.documentElement.append(gesture);
  return new XMLSerializer().serializeToString(root);
}
