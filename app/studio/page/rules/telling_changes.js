/** What edited rules change in a line: in words, and as rules call it. */

import { functionName } from "../naming/meanings.js";
import { plain } from "../naming/movements.js";

/** @import { RuleComparison } from "understudy-client" */

/** @typedef {RuleComparison["changes"][number]} LineChange */
/** @typedef {LineChange["offers_before"][number]} Offer */
/** `−` is there no more, `+` is new, `~` is likelier or less likely. @typedef {Readonly<{ sign: "−" | "+" | "~", text: string, technical: string }>} Told */

/**
 * What is there no more, what is likelier or less likely, and what is new; what a line means before what is done for it.
 *
 * @param {LineChange} change
 * @returns {Told[]}
 */
export function toldChanges({ functions_before, functions_after, offers_before, offers_after }) {
  const matches = (/** @type {Offer} */ one) => (/** @type {Offer} */ other) => keyOf(one) === keyOf(other);
  const gone = offers_before.filter((offer) => !offers_after.some(matches(offer)));
  const added = offers_after.filter((offer) => !offers_before.some(matches(offer)));
  const other = offers_before.flatMap((offer) => {
    const after = offers_after.find(matches(offer));
    return after ? [toldWeight(offer, after)] : [];
  });
  return [
    ...functions_before.map((meant) => toldMeaning("−", meant)),
    ...gone.map((offer) => toldOffer("−", offer)),
    ...other,
    ...functions_after.map((meant) => toldMeaning("+", meant)),
    ...added.map((offer) => toldOffer("+", offer)),
  ];
}

/**
 * @param {"−" | "+"} sign
 * @param {LineChange["functions_before"][number]} meant
 * @returns {Told}
 */
function toldMeaning(sign, { class: of, subtype, text, priority, kept, rule }) {
  const name = functionName({ class: of, subtype });
  const read = `“${text}” ${sign === "+" ? "is" : "is no longer"} read as ${name}`;
  return { sign, text: kept ? read : `${read}, which gives way to another`, technical: `${[of, subtype].filter(Boolean).join(" ")}, priority ${String(priority)} (${rule})` };
}

/**
 * @param {"−" | "+"} sign
 * @param {Offer} offer
 * @returns {Told}
 */
function toldOffer(sign, offer) {
  return { sign, text: `${named(offer)} ${sign === "+" ? "is" : "is no longer"} offered`, technical: `weight ${String(offer.weight)} (${offer.rule})` };
}

/**
 * @param {Offer} before
 * @param {Offer} after
 * @returns {Told}
 */
function toldWeight(before, after) {
  const text = `${named(before)} is ${after.weight > before.weight ? "likelier" : "less likely"}`;
  return { sign: "~", text, technical: `weight ${String(before.weight)}, then ${String(after.weight)} (${before.rule})` };
}

/** @param {Offer} offer */
function named({ name, class: of }) {
  return `${plain(name)}, for ${functionName({ class: of })},`;
}

/** @param {Offer} offer */
function keyOf({ name, rule, class: of, first, last }) {
  return JSON.stringify([name, rule, of, first, last]);
}
