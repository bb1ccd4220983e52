/** The gestures' families in groups by what they mean, with other words under which people look for them. */

import { familyName } from "./meanings.js";
import { movementName } from "./movements.js";

/** @typedef {Readonly<{ name: string, words: string, families: readonly string[] }>} Group */

/** @type {readonly Group[]} */
export const GROUPS = Object.freeze([
  { name: "Yes, no and perhaps", words: "agree disagree refuse reject know unsure doubt don't", families: ["accept", "negation", "stop_refuse", "none_empty", "shrug", "question", "dismiss"] },
  { name: "People and places", words: "point person i you we they where", families: ["self", "addressee", "group", "point_here", "point_there", "point_up", "left", "right"] },
  { name: "Giving and showing", words: "hand present idea topic", families: ["present", "offer_give", "heart", "please"] },
  { name: "Size and shape", words: "large little tall measure", families: ["size_big", "size_small", "shape"] },
  { name: "Ways and directions", words: "go move come leave path", families: ["up", "down", "forward", "back", "approach", "away", "through_path", "contain_in", "out"] },
  { name: "Counting and comparing", words: "list first number versus against balance", families: ["count", "list_item", "contrast_sides", "compare_levels", "weigh", "join", "separate", "all_sweep"] },
  { name: "Time and order", words: "when before after begin finish change", families: ["past", "future", "now", "begin", "end_cut", "cycle", "turn_over_change"] },
  { name: "Emphasis", words: "stress strong important rhythm", families: ["beat", "chop", "fist", "precision"] },
  { name: "Manners and feelings", words: "polite hi bye sorry", families: ["greet", "farewell", "thanks", "apologise"] },
  { name: "Thinking and quoting", words: "think idea word say", families: ["think", "word_search", "quote"] },
  { name: "Acting it out", words: "mime pantomime do", families: ["emblem_other"] },
  { name: "Others", words: "", families: [] },
]);

/**
 * The group of a gesture, by what it is read as, the likeliest first.
 *
 * @param {readonly string[]} families
 * @returns {Group}
 */
export function groupOf(families) {
  const found = families.flatMap((family) => GROUPS.find((group) => group.families.includes(family)) ?? []);
  return found[0] ?? /** @type {Group} */ (GROUPS.at(-1));
}

/**
 * Everything that a gesture can be looked for by.
 *
 * @param {string} lexeme
 * @param {readonly string[]} families
 */
export function searchedText(lexeme, families) {
  const meant = families.map((family) => `${family} ${familyName(family)}`).join(" ");
  const plain = `${movementName("gesture", lexeme)} ${lexeme} ${meant}`;
  return `${plain} ${groupOf(families).name} ${groupOf(families).words}`.toLowerCase().replaceAll("_", " ");
}
