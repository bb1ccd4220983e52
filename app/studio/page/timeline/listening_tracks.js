/** What is heard beside the words: how the voice sounds from phrase to phrase, and on which words the line's focus is. */

import { plain } from "../naming/movements.js";
import { strongest } from "../naming/tones.js";
import { within } from "./items.js";

/** @import { Performance } from "understudy-client" */
/** @import { Loose } from "./tracks.js" */

/**
 * @param {Performance} performance
 * @returns {Loose[]}
 */
export function feelingItems({ affect, words }) {
  return (affect?.phrases ?? []).flatMap(({ first, last, tones, activation, valence, dominance }, index) => {
    const [tone, share] = strongest(tones);
    const measured = Object.entries({ activation, valence, dominance }).map(([name, value]) => `${name} ${value.toFixed(2)}`);
    const technical = [...measured, `${tone} ${share.toFixed(2)}`].join(", ");
    const items = within(`feeling:${String(index)}`, plain(tone), words[first]?.start_s, words[last]?.end_s);
    return items.map((item) => ({ ...item, technical }));
  });
}

/** The least share of the largest that is shown. */
const LEAST = 0.15;

/**
 * The words that have some of the focus, as high as their share is of the largest.
 *
 * @param {Performance} performance
 * @returns {Loose[]}
 */
export function focusItems({ focus, words }) {
  const most = Math.max(0.01, ...focus.map(({ share }) => share));
  return focus.filter(({ share }) => share >= LEAST * most).flatMap(({ word, share }) => {
    const items = within(`word:${String(word)}`, words[word]?.text ?? "", words[word]?.start_s, words[word]?.end_s);
    return items.map((item) => ({ ...item, technical: `focus ${share.toFixed(2)}`, share: share / most }));
  });
}
