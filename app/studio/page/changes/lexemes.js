/** The movements that can be asked for by channel, and what gestures may be read as. */

import { problemOf } from "../service/service.js";
import { PROBLEM } from "../state/performed.js";
import { slice } from "../state/slice.js";

/** @import { Gestures } from "understudy-client" */
/** @import { Service } from "../service/service.js" */
/** @import { Store } from "../state/store.js" */

/** The lexemes and their families, as the service has them. */
export class Lexemes {
  #told;

  /** @param {Pick<Gestures, "lexemes" | "families"> | null} told null before they are known */
  constructor(told) {
    this.#told = told;
  }

  /**
   * @param {string} channel
   * @returns {readonly string[]}
   */
  of(channel) {
    return this.#told?.lexemes[/** @type {keyof Gestures["lexemes"]} */ (channel)] ?? [];
  }

  /**
   * What a gesture may be read as, the likeliest first.
   *
   * @param {string} lexeme
   * @returns {readonly string[]}
   */
  familiesOf(lexeme) {
    return this.#told?.families[lexeme] ?? [];
  }

  /** Every family that some gesture shows, in alphabetical order. */
  get families() {
    return [...new Set(this.of("gesture").flatMap((lexeme) => [...this.familiesOf(lexeme)]))].sort();
  }
}

export const LEXEMES = slice(new Lexemes(null));

/**
 * @param {Store} store
 * @param {Service} service
 */
export async function askForLexemes(store, service) {
  try {
    store.set(LEXEMES, new Lexemes(await service.client.listGestures()));
  } catch (error) {
    store.set(PROBLEM, problemOf(error));
  }
}
