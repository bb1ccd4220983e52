/** What people call that which a line means (functions) and what a movement may say (families). */

import { plain } from "./movements.js";

/** @type {Readonly<Record<string, string>>} */
const FAMILIES = Object.freeze({
  self: "me", addressee: "you", group: "us", point_here: "here", point_there: "over there", point_up: "up there",
  negation: "no", stop_refuse: "stop", question: "a question", shrug: "who knows", present: "showing it",
  offer_give: "offering", size_big: "big", size_small: "small", shape: "its shape", count: "a number",
  list_item: "an item of a list", all_sweep: "everything", none_empty: "nothing there", precision: "exactly",
  beat: "the beat", chop: "firmness", fist: "force", contrast_sides: "one side and the other",
  compare_levels: "more or less", weigh: "weighing up", join: "together", separate: "apart", up: "up", down: "down",
  left: "left", right: "right", forward: "ahead", back: "back", approach: "nearer", away: "away",
  through_path: "the way", contain_in: "inside", out: "out", cycle: "on and on", turn_over_change: "a change",
  begin: "a beginning", end_cut: "the end", past: "the past", future: "the future", now: "now", think: "thinking",
  heart: "from the heart", accept: "yes", dismiss: "waving it off", greet: "hello", farewell: "goodbye",
  thanks: "thanks", apologise: "sorry", please: "please", quote: "in quotes", word_search: "looking for a word",
  emblem_other: "acting it out", still: "stillness", nod: "a nod", shake: "a shake of the head",
  tilt: "a tilt of the head", tilted_nod: "a tilted nod", toss: "a toss of the head", turn: "a turn of the head",
  lean_in: "leaning in", lean_back: "leaning back", brows_up: "raised brows", frown: "a frown", smile: "a smile", sad: "sadness",
  squint: "narrowed eyes", wide_eyes: "wide eyes", lips_pressed: "pressed lips", disgust: "disgust",
  neutral: "a neutral face", listener: "the listener", target: "what is spoken of",
});

/** By class, or by class and subtype. @type {Readonly<Record<string, string>>} */
const FUNCTIONS = Object.freeze({
  affirmation: "a yes", apology: "an apology", comparison: "a comparison", container: "something that holds",
  contrast: "a contrast", deixis: "somebody or some place that is meant", "deixis.self": "the speaker",
  "deixis.addressee": "the person spoken to", "deixis.inclusive": "all of us",
  "deixis.distal": "something over there", "deixis.proximal": "something here", emphasis: "a word the voice stresses",
  enumeration: "an item of a list", greeting: "a greeting", hedging: "a doubt", height: "a height", idea: "an idea",
  inclusion: "everybody", information: "what is known or new", initial_noun_phrase: "who or what it is about", initial_verb_phrase: "what is done",
  intensifier: "a strong word", interrogative: "a question", "interrogative.polar": "a yes-or-no question",
  locus: "a place", mental: "a state of mind", "mental.know": "knowing", modal: "a may or must",
  "modal.obligation": "a must", negation: "a no", obligation: "a duty", parenthesis: "an aside", parting: "a goodbye",
  path: "a way", performance: "something that is acted out", physical: "something that is done",
  politeness: "politeness", process: "something that goes on", quantification: "an amount",
  "quantification.all": "all of it", "quantification.none": "none of it", "quantification.some": "some of it",
  quoting: "somebody else's words", spatial: "a direction", "spatial.back": "back", thanks: "thanks", time: "a time",
  topic_shift: "a new subject", valence: "a judgement", "valence.positive": "something good",
  "valence.negative": "something bad", "comparison.superlative": "the most",
});

/** @param {string} family */
export function familyName(family) {
  return FAMILIES[family] ?? plain(family).toLowerCase();
}

/** @param {Readonly<{ class: string, subtype?: string | null | undefined }>} meant */
export function functionName({ class: of, subtype }) {
  return FUNCTIONS[`${of}.${subtype ?? ""}`] ?? FUNCTIONS[of] ?? plain(of).toLowerCase();
}
