/** Says in a sentence what something on the timeline is, and why it is there. Pure; the numbers are telling.js's. */

import { familyName, functionName } from "../naming/meanings.js";
import { strongest } from "../naming/tones.js";
import { channelName, handName, movementName, plain, plainText } from "../naming/movements.js";

/** @import { Behavior, BehaviorEdit, Performance } from "understudy-client" */
/** @import { FoundFunction } from "./telling.js" */

/**
 * What is selected: its name, the technical one, what more there is to say of it, and why it is there.
 *
 * @typedef {Readonly<{ name: string, technical: string, about: string, why: string }>} Said
 */

/**
 * @param {Performance} performance
 * @param {string} id
 * @param {BehaviorEdit} [edit] what an author changed in it
 * @returns {Said | null} null where nothing has this id
 */
export function saidOf(performance, id, edit) {
  const behavior = performance.behaviors.find((each) => each.id === id);
  if (behavior) {
    return saidOfBehavior(performance, behavior, edit);
  }
  const found = performance.functions.find((each) => each.id === id);
  return found ? saidOfFunction(performance, found) : saidOfSound(performance, id);
}

/**
 * @param {Performance} performance
 * @param {Behavior} behavior
 * @param {BehaviorEdit} [edit]
 * @returns {Said}
 */
function saidOfBehavior(performance, behavior, edit) {
  const { kind, lexeme, hand, first, last, id } = behavior;
  const about = [channelName(kind), handName(hand), quoted(performance, first, last)].filter(Boolean).join(" · ");
  return { name: movementName(kind, lexeme), technical: `${kind} ${lexeme}, ${id}`, about, why: whyOf(performance, behavior, edit) };
}

/**
 * @param {Performance} performance
 * @param {Behavior} behavior
 * @param {BehaviorEdit} [edit]
 */
export function whyOf(performance, behavior, edit) {
  const note = behavior.reason ? plainText(behavior.reason) : "";
  if (!behavior.kept) {
    return `It is not made: ${note || "something else was worth more there"}.`;
  }
  const meant = [meantBy(performance, behavior), chosenFor(performance, behavior)].filter(Boolean).join("; ");
  const told = [...(typeof behavior.edit === "number" ? changedBy(behavior, meant, edit) : [meant]), note].filter(Boolean);
  return (told.length > 0 ? told : [ALIVE]).map(sentence).join(" ");
}

/**
 * What an author did, and beside it what it was, or would be, without that.
 *
 * @param {Behavior} behavior
 * @param {string} meant
 * @param {BehaviorEdit} [edit]
 */
function changedBy(behavior, meant, edit) {
  if (isChosen(behavior, edit)) {
    const chosen = `you chose “${movementName(behavior.kind, behavior.lexeme)}” here`;
    return meant ? [chosen, `left to itself, the performer would go by this: ${meant}`] : [chosen];
  }
  return meant ? ["you changed it", meant] : ["you added it"];
}

/**
 * Whether an author put it in the place of something else.
 *
 * @param {Behavior} behavior
 * @param {BehaviorEdit} [edit]
 */
function isChosen({ lexeme }, edit) {
  return edit?.of?.lexeme !== undefined && edit.lexeme === lexeme && edit.of.lexeme !== lexeme;
}

const ALIVE = "so that the body is alive between what it says";

/**
 * @param {Performance} performance
 * @param {Behavior} behavior
 */
function meantBy({ functions }, behavior) {
  const cause = functions.find(({ id }) => id === behavior.function);
  return cause ? `“${cause.text}” is ${functionName(cause)}` : "";
}

/**
 * @param {Performance} performance
 * @param {Behavior} behavior
 */
function chosenFor({ moments }, behavior) {
  const [best, next] = (moments.find(({ id }) => id === behavior.moment)?.families ?? []).map(familyName);
  return best ? `the best fit is “${best}”${next ? `, then “${next}”` : ""}` : "";
}

/**
 * @param {Performance} performance
 * @param {FoundFunction} found
 * @returns {Said}
 */
function saidOfFunction(performance, found) {
  const { first, last, kept, lost_to: lostTo } = found;
  const winner = performance.functions.find(({ id }) => id === lostTo);
  const shown = performance.behaviors.filter((each) => each.kept && each.function === found.id);
  const names = shown.map(({ kind, lexeme }) => `“${movementName(kind, lexeme)}”`).join(", ");
  const why = kept
    ? `“${found.text}” is ${functionName(found)}. ${names ? `It is shown by ${names}.` : "Nothing shows it."}`
    : `“${found.text}” may be ${functionName(found)}, but ${winner ? functionName(winner) : "something else"} says more.`;
  const technical = ["function", [found.class, found.subtype].filter(Boolean).join("."), found.id].join(" ");
  return { name: plain(functionName(found)), technical, about: `Meaning · ${quoted(performance, first, last)}`, why };
}

/**
 * @param {Performance} performance
 * @param {string} id
 * @returns {Said | null}
 */
function saidOfSound({ words, visemes, affect }, id) {
  const [kind, number] = id.split(":");
  const word = kind === "word" ? words[Number(number)] : undefined;
  if (word) {
    return { name: `“${word.text}”`, technical: `word ${String(word.index)}`, about: "Word", why: wordSaid(word) };
  }
  if (kind === "feeling") {
    return saidOfFeeling({ affect, words }, Number(number));
  }
  const viseme = kind === "viseme" ? visemes.filter(({ label }) => label !== "sil")[Number(number)] : undefined;
  return viseme ? { name: `Lips for ${viseme.label}`, technical: `viseme ${viseme.label}`, about: "Lips", why: "The lips follow the sounds." } : null;
}

/**
 * @param {Pick<Performance, "words" | "affect">} performance
 * @param {number} index
 * @returns {Said | null}
 */
function saidOfFeeling({ affect, words }, index) {
  const phrase = affect?.phrases[index];
  if (!phrase) {
    return null;
  }
  const [tone, share] = strongest(phrase.tones);
  const why = affect.given ? "The feeling was given." : `The voice sounds ${tone} here, with ${(100 * share).toFixed(0)} of 100 parts.`;
  const text = quoted({ words }, phrase.first, phrase.last);
  return { name: plain(tone), technical: `affect ${phrase.activation.toFixed(2)} ${phrase.valence.toFixed(2)} ${phrase.dominance.toFixed(2)}`, about: `Feeling · ${text}`, why };
}

/** @param {Performance["words"][number]} word */
function wordSaid({ emphasis, spread }) {
  const stress = (emphasis ?? 0) >= 0.5 ? "The voice stresses it." : "The voice does not stress it.";
  return spread ? `${stress} When it is spoken is only estimated.` : stress;
}

/**
 * @param {Pick<Performance, "words">} performance
 * @param {number} first
 * @param {number} last
 */
function quoted({ words }, first, last) {
  return `“${words.slice(first, last + 1).map(({ text }) => text).join(" ")}”`;
}

/** @param {string} text */
function sentence(text) {
  return `${text.charAt(0).toUpperCase()}${text.slice(1)}.`;
}
