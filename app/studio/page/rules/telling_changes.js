/** What edited rules change in a line, in words. */

/** @import { RuleComparison } from "understudy-client" */

/** @typedef {RuleComparison["changes"][number]} LineChange */

/**
 * What is there no more (`-`) and what is new (`+`), functions before behaviours.
 *
 * @param {LineChange} change
 * @returns {{ sign: "+" | "-", text: string }[]}
 */
export function toldChanges(change) {
  const functions = (/** @type {LineChange["functions_before"]} */ found) =>
    found.map((each) => {
      const lost = each.kept ? "" : ", loses";
      return `${[each.class, each.subtype].filter(Boolean).join(" ")} “${each.text}”, priority ${String(each.priority)}${lost} (${each.rule})`;
    });
  const offers = (/** @type {LineChange["offers_before"]} */ found) =>
    found.map(({ name, rule, weight, class: of }) => `${name} for ${of}, weight ${String(weight)} (${rule})`);
  return [
    ...signed("-", [...functions(change.functions_before), ...offers(change.offers_before)]),
    ...signed("+", [...functions(change.functions_after), ...offers(change.offers_after)]),
  ];
}

/**
 * @param {"+" | "-"} sign
 * @param {readonly string[]} texts
 */
function signed(sign, texts) {
  return texts.map((text) => ({ sign, text }));
}
