/**
 * What the timeline shows, from top to bottom: rows with items in time. Items of a row that overlap lie in lanes below
 * each other; what was dropped lies below what was kept.
 */

import { MARKS, phasesOf } from "./phases.js";

/** @import { Behavior, Performance } from "understudy-client" */
/** @import { Phase } from "./phases.js" */

/**
 * Something in time. `id` is what SELECTION has for it; `marks` are its sync points, `phases` those of a gesture; `why`
 * says why it was dropped.
 *
 * @typedef {object} Item
 * @property {string} id
 * @property {string} label
 * @property {number} start_s
 * @property {number} end_s
 * @property {boolean} kept
 * @property {number} lane
 * @property {readonly (readonly [mark: string, time_s: number])[]} marks
 * @property {readonly Phase[]} phases
 * @property {string} why
 */

/** @typedef {"wave" | "voice" | "items"} RowKind */

/** @typedef {Readonly<{ name: string, kind: RowKind, items: readonly Item[], lanes: number }>} Row */

/** The channels of behaviours, in the order in which they are shown. */
export const CHANNELS = /** @type {const} */ (["gesture", "head", "gaze", "face", "eyes", "posture"]);

/**
 * @param {Performance} performance
 * @returns {Row[]}
 */
export function rowsOf(performance) {
  return [
    { name: "words", kind: "wave", items: wordItems(performance), lanes: 1 },
    row("phones", phoneItems(performance)),
    { name: "voice", kind: "voice", items: [], lanes: 1 },
    ...CHANNELS.map((channel) => row(channel, behaviorItems(performance, channel))),
    row("functions", functionItems(performance)),
    row("visemes", visemeItems(performance)),
  ];
}

/**
 * Every item that can be selected, in the order of time.
 *
 * @param {readonly Row[]} rows
 */
export function listed(rows) {
  const chosen = rows.filter(({ name }) => name !== "phones" && name !== "visemes");
  return chosen
    .flatMap(({ name, items }) => items.map((item) => ({ row: name, item })))
    .sort((a, b) => a.item.start_s - b.item.start_s);
}

/**
 * @param {string} name
 * @param {readonly Omit<Item, "lane">[]} items
 * @returns {Row}
 */
function row(name, items) {
  const kept = inLanes(items.filter((item) => item.kept), 0);
  const lanesOfKept = lanesOf(kept, 1);
  const dropped = inLanes(items.filter((item) => !item.kept), lanesOfKept);
  return { name, kind: "items", items: [...kept, ...dropped], lanes: lanesOf(dropped, lanesOfKept) };
}

/**
 * @param {readonly Item[]} items
 * @param {number} least
 */
function lanesOf(items, least) {
  return items.reduce((most, { lane }) => Math.max(most, lane + 1), least);
}

/**
 * Puts each item into the first lane where nothing is in its way.
 *
 * @param {readonly Omit<Item, "lane">[]} items
 * @param {number} first
 * @returns {Item[]}
 */
function inLanes(items, first) {
  /** @type {number[]} when each lane is free again */
  const free_s = [];
  return [...items]
    .sort((a, b) => a.start_s - b.start_s)
    .map((item) => {
      const found = free_s.findIndex((end_s) => end_s <= item.start_s);
      const lane = found < 0 ? free_s.length : found;
      free_s[lane] = item.end_s;
      return { ...item, lane: first + lane };
    });
}

/** @param {Performance} performance */
function wordItems({ words }) {
  const items = words.flatMap(({ index, text, start_s, end_s }) => within(`word:${String(index)}`, text, start_s, end_s));
  return items.map(withEdges).map(on(0));
}

/**
 * A word with its edges as marks, by which it is dragged.
 *
 * @param {Omit<Item, "lane">} item
 * @returns {Omit<Item, "lane">}
 */
function withEdges(item) {
  return { ...item, marks: [["start", item.start_s], ["end", item.end_s]] };
}

/** @param {Performance} performance */
function phoneItems({ words }) {
  return words.flatMap(({ index, phones }) =>
    phones.flatMap(({ label, start_s, end_s }) => within(`word:${String(index)}`, label, start_s, end_s)),
  );
}

/** @param {Performance} performance */
function visemeItems({ visemes }) {
  return visemes
    .filter(({ label }) => label !== "sil")
    .flatMap(({ label, start_s, end_s }, index) => within(`viseme:${String(index)}`, label, start_s, end_s));
}

/** @param {Performance} performance */
function functionItems({ functions }) {
  return functions.flatMap((each) =>
    within(each.id, [each.class, each.subtype].filter(Boolean).join("."), each.start_s, each.end_s).map((item) => ({
      ...item,
      kept: each.kept,
      why: each.lost_to ? `gave way to ${each.lost_to}` : "",
    })),
  );
}

/**
 * @param {Performance} performance
 * @param {string} channel
 */
function behaviorItems({ behaviors }, channel) {
  return behaviors.filter(({ kind }) => kind === channel).map(behaviorItem);
}

/** @param {Behavior} behavior */
function behaviorItem({ id, kind, lexeme, hand, sync, kept, reason, lost_to: lostTo }) {
  const marks = MARKS.flatMap((mark) => (sync[mark] === undefined ? [] : [/** @type {const} */ ([mark, sync[mark]])]));
  const times_s = marks.map(([, time_s]) => time_s);
  return {
    id,
    label: hand ? `${lexeme} (${hand})` : lexeme,
    start_s: Math.min(...times_s),
    end_s: Math.max(...times_s),
    kept,
    marks,
    phases: kind === "gesture" ? phasesOf(sync) : [],
    why: kept ? "" : [reason, lostTo && `gave way to ${lostTo}`].filter(Boolean).join("; "),
  };
}

/**
 * An item that has a time, else none.
 *
 * @param {string} id
 * @param {string} label
 * @param {number | null | undefined} start_s
 * @param {number | null | undefined} end_s
 * @returns {Omit<Item, "lane">[]}
 */
function within(id, label, start_s, end_s) {
  const isTimed = typeof start_s === "number" && typeof end_s === "number";
  return isTimed ? [{ id, label, start_s, end_s, kept: true, marks: [], phases: [], why: "" }] : [];
}

/** @param {number} lane */
function on(lane) {
  return (/** @type {Omit<Item, "lane">} */ item) => ({ ...item, lane });
}
