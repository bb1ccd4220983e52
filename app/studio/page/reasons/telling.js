/** Says of anything on the timeline what it is, what it comes from, and what lost to it. Pure: what is shown is text. */

import { MARKS } from "../timeline/phases.js";
import { behaviorTold, functionTold, lostTold, nameOf, ruleTold, seconds, signed, wordsTold, wordTold } from "./naming.js";

/** @import { Behavior, Performance } from "understudy-client" */

/** A text; `id` is what it selects, `rule` the rule that it names. @typedef {Readonly<{ text: string, id?: string, rule?: string }>} Told */
/** @typedef {Readonly<{ title: string, told: readonly Told[] }>} Section */
/** @typedef {Performance["functions"][number]} FoundFunction */
/** @typedef {Performance["moments"][number]} Moment */

/**
 * The sections on whatever has an id; none where nothing has it.
 *
 * @param {Performance} performance
 * @param {string} id
 * @returns {Section[]}
 */
export function sectionsOn(performance, id) {
  const behavior = performance.behaviors.find((each) => each.id === id);
  if (behavior) {
    return onBehavior(performance, behavior);
  }
  const found = performance.functions.find((each) => each.id === id);
  if (found) {
    return onFunction(performance, found);
  }
  const [kind, number] = id.split(":");
  if (kind === "viseme") {
    return onViseme(performance, Number(number));
  }
  return kind === "word" ? onWord(performance, Number(number)) : [];
}

/**
 * @param {Performance} performance
 * @param {Behavior} behavior
 * @returns {Section[]}
 */
function onBehavior(performance, behavior) {
  const { kind, lexeme, hand, rule, sync, first, last, priority } = behavior;
  const cause = performance.functions.find((each) => each.id === behavior.function);
  const moment = performance.moments.find((each) => each.id === behavior.moment);
  const marks = MARKS.filter((mark) => sync[mark] !== undefined).map((mark) => `${mark} ${seconds(sync[mark])}`);
  return [
    { title: `${kind} ${lexeme}${hand ? ` (${hand})` : ""}`, told: [wordsTold(performance, first, last), { text: marks.join(" · ") }] },
    section("Dropped", behavior.kept ? [] : [lostTold(behavior)]),
    section("Because", [
      ...(rule ? [{ text: `rule ${rule}, priority ${priority.toFixed(1)}`, rule }] : []),
      ...(cause ? [functionTold(cause)] : []),
      ...(behavior.reason && behavior.kept ? [{ text: behavior.reason }] : []),
    ]),
    ...(moment ? onMoment(moment) : []),
    section("Gave way to it", losersTo(performance, behavior.id)),
  ].filter(({ told }) => told.length > 0);
}

/**
 * @param {Moment} moment
 * @returns {Section[]}
 */
function onMoment({ families, shares, terms, rejected, importance, note }) {
  const chances = families.map((family, index) => `${family} ${(shares[index] ?? 0).toFixed(2)}`);
  return [
    section(`What the moment could show (importance ${importance.toFixed(2)})`, [
      { text: chances.join(" · ") },
      ...(typeof note === "number" ? [{ text: `by note ${String(note)} of the director` }] : []),
    ]),
    section("Terms (log-odds)", terms.map(({ name, weight }) => ({ text: `${signed(weight)}  ${name}` }))),
    section("What lost", rejected.map((each) => ({ text: `${each.families.join(", ")} (${each.worth.toFixed(2)}): ${each.reason}` }))),
  ];
}

/**
 * @param {Performance} performance
 * @param {FoundFunction} found
 * @returns {Section[]}
 */
function onFunction(performance, found) {
  const because = found.because.map(({ word, rule, fact }) =>
    typeof word === "number" ? wordTold(performance, word) : ruleTold(rule, fact),
  );
  const shown = performance.behaviors.filter((each) => each.function === found.id);
  return [
    { title: `function ${nameOf(found)}`, told: [wordsTold(performance, found.first, found.last)] },
    section("Dropped", found.kept ? [] : [lostTold(found)]),
    section("Because", [{ text: `rule ${found.rule}, priority ${found.priority.toFixed(1)}`, rule: found.rule }, ...because]),
    section("Shown by", shown.map(behaviorTold)),
    section("Gave way to it", losersTo(performance, found.id)),
  ].filter(({ told }) => told.length > 0);
}

/**
 * @param {Performance} performance
 * @param {number} index
 * @returns {Section[]}
 */
function onWord(performance, index) {
  const word = performance.words[index];
  if (!word) {
    return [];
  }
  const covers = (/** @type {{ first: number, last: number }} */ { first, last }) => first <= index && index <= last;
  const measures = /** @type {const} */ (["emphasis", "prominence", "stressed_ratio"]);
  const measured = measures.flatMap((name) => (typeof word[name] === "number" ? [`${name.replace("_", " ")} ${word[name].toFixed(2)}`] : []));
  const times = `${seconds(word.start_s ?? undefined)} to ${seconds(word.end_s ?? undefined)}${word.spread ? " (estimated)" : ""}`;
  const phones = word.phones.map(({ label, stress }) => `${label}${stress ?? ""}`).join(" ");
  return [
    { title: `word ${String(index)} “${word.text}”`, told: [times, phones, measured.join(" · ")].filter(Boolean).map((text) => ({ text })) },
    section("Functions", performance.functions.filter(covers).map(functionTold)),
    section("Behaviours", performance.behaviors.filter(covers).map(behaviorTold)),
  ].filter(({ told }) => told.length > 0);
}

/**
 * @param {Performance} performance
 * @param {number} index
 * @returns {Section[]}
 */
function onViseme({ visemes }, index) {
  const viseme = visemes.filter(({ label }) => label !== "sil")[index];
  if (!viseme) {
    return [];
  }
  const { label, start_s, end_s, articulation, opening } = viseme;
  const reached = `reached ${articulation.toFixed(2)} of its shape, jaw open ${opening.toFixed(2)}`;
  return [{ title: `viseme ${label}`, told: [{ text: `${seconds(start_s)} to ${seconds(end_s)}` }, { text: reached }] }];
}

/**
 * @param {string} title
 * @param {readonly Told[]} told
 * @returns {Section}
 */
function section(title, told) {
  return { title, told };
}

/**
 * @param {Performance} performance
 * @param {string} id
 */
function losersTo({ functions, behaviors }, id) {
  const lost = (/** @type {{ lost_to?: string | null | undefined }} */ each) => each.lost_to === id;
  return [...functions.filter(lost).map(functionTold), ...behaviors.filter(lost).map(behaviorTold)];
}
