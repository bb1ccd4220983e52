/** Shows that a file is being made: how much of it is there, and a button to give it up. One is made at a time. */

import { el } from "../dom.js";
import { PLAYBACK } from "../state/performed.js";
import { slice } from "../state/slice.js";

/** @import { Store } from "../state/store.js" */

/** Whether a file is being made. */
export const MAKING = slice(false);

export class Making {
  #store;
  #bar = el("progress", { max: 1, value: 0, "aria-label": "Made so far" });
  #share = el("span", {});
  #said = el("p", { id: "exported", role: "status", class: "quiet" });
  #cancel = el("button", { type: "button", id: "cancel-export", click: () => this.#giveUp() }, ["Cancel"]);
  #row = el("div", { class: "row", id: "making", hidden: true }, [this.#bar, this.#share, this.#cancel]);
  #underWay = new AbortController();
  element = el("div", {}, [this.#row, this.#said]);

  /** @param {Store} store */
  constructor(store) {
    this.#store = store;
  }

  /**
   * Tells how far it is, from 0 to 1. Throws the signal's reason where it was given up.
   *
   * @param {number} share
   */
  tell(share) {
    this.#row.hidden = false;
    this.#bar.value = share;
    this.#share.textContent = `${String(Math.round(share * 100))} %`;
    this.#underWay.signal.throwIfAborted();
  }

  /**
   * Has something made and says what came of it; null where it was given up. Rejects as `make` does.
   *
   * @template Made
   * @param {() => Promise<Made>} make
   * @returns {Promise<Made | null>}
   */
  async make(make) {
    this.#underWay = new AbortController();
    this.#store.set(MAKING, true);
    this.say("Making it…");
    try {
      const made = await make();
      return this.#underWay.signal.aborted ? null : made;
    } catch (error) {
      if (this.#underWay.signal.aborted) {
        return null;
      }
      throw error;
    } finally {
      this.say(this.#underWay.signal.aborted ? "Cancelled" : "");
      this.#row.hidden = true;
      this.#store.set(MAKING, false);
    }
  }

  /** @param {string} text */
  say(text) {
    this.#said.textContent = text;
  }

  /** A film that is recorded while the line is played ends with the playing. */
  #giveUp() {
    this.#store.patch(PLAYBACK, { playing: false });
    this.#underWay.abort();
  }
}
