/**
 * What the timeline shows, from top to bottom: rows with items in time. Items of a row that overlap lie in lanes below
 * each other; what was dropped lies below what was kept.
 */

import { functionName } from "../naming/meanings.js";
import { handName, movementName, plain, plainText } from "../naming/movements.js";
import { feelingItems, focusItems } from "./listening_tracks.js";
import { within } from "./items.js";
import { MARKS, phasesOf } from "./phases.js";

/** @import { Behavior, Performance } from "understudy-client" */
/** @import { Phase } from "./phases.js" */

/**
 * Something in time. `id` is what SELECTION has for it; `marks` are its sync points, `phases` those of a gesture; `why`
 * says why it was dropped. `label` is what people call it, `technical` what the service does; `next_s` is when something
 * else begins in its lane, `share` how much of the lane's height it fills.
 *
 * @typedef {object} Item
 * @property {string} id
 * @property {string} label
 * @property {string} technical
 * @property {number} start_s
 * @property {number} end_s
 * @property {boolean} kept
 * @property {number} lane
 * @property {readonly (readonly [mark: string, time_s: number])[]} marks
 * @property {readonly Phase[]} phases
 * @property {string} why
 * @property {number} next_s
 * @property {number} [share]
 */

/** An item that is in no lane yet. @typedef {Omit<Item, "lane" | "next_s">} Loose */

/** @typedef {"wave" | "voice" | "items"} RowKind */

/** @typedef {Readonly<{ name: string, kind: RowKind, items: readonly Item[], lanes: number }>} Row */

/** The channels of behaviours, in the order in which they are shown. */
export const CHANNELS = /** @type {const} */ (["gesture", "head", "gaze", "face", "eyes", "posture"]);

/**
 * What is shown of a performance: `alternatives` are what gave way; `others` are movements that only the version that it is
 * compared with has.
 *
 * @param {Performance} performance
 * @param {Readonly<{ alternatives: boolean, others?: readonly Behavior[] }>} [shown]
 * @returns {Row[]}
 */
export function rowsOf(performance, { alternatives, others = [] } = { alternatives: true }) {
  const row = (/** @type {string} */ name, /** @type {readonly Loose[]} */ items) => rowOf(name, items, alternatives);
  return [
    { name: "words", kind: "wave", items: wordItems(performance), lanes: 1 },
    row("focus", focusItems(performance)),
    ...CHANNELS.map((channel) => row(channel, behaviorItems(performance, channel))),
    ...(others.length > 0 ? [row("compared", others.map((each) => ({ ...behaviorItem(each), id: `compared:${each.id}` })))] : []),
    row("feeling", feelingItems(performance)),
    row("functions", functionItems(performance)),
    { name: "voice", kind: "voice", items: [], lanes: 1 },
    row("phones", phoneItems(performance)),
    row("visemes", visemeItems(performance)),
  ];
}

/**
 * Every item that can be selected, in the order of time.
 *
 * @param {readonly Row[]} rows
 */
export function listed(rows) {
  const chosen = rows.filter(({ name }) => !UNLISTED.includes(name));
  return chosen
    .flatMap(({ name, items }) => items.map((item) => ({ row: name, item })))
    .sort((a, b) => a.item.start_s - b.item.start_s);
}

/** What the list leaves out: the words are in it already. */
const UNLISTED = ["phones", "visemes", "focus", "compared"];

/** What an author took out himself is never hidden: it is to be taken back. */
const BY_AUTHOR = /by the author/;

/**
 * @param {string} name
 * @param {readonly Loose[]} items
 * @param {boolean} alternatives
 * @returns {Row}
 */
function rowOf(name, items, alternatives) {
  const kept = inLanes(items.filter((item) => item.kept), 0);
  const lanesOfKept = lanesOf(kept, 1);
  const dropped = inLanes(items.filter((item) => !item.kept && (alternatives || BY_AUTHOR.test(item.why))), lanesOfKept);
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
 * @param {readonly Loose[]} items
 * @param {number} first
 * @returns {Item[]}
 */
function inLanes(items, first) {
  /** @type {Item[]} the last of each lane */
  const last = [];
  return [...items]
    .sort((a, b) => a.start_s - b.start_s)
    .map((item) => {
      const found = last.findIndex(({ end_s }) => end_s <= item.start_s);
      const lane = found < 0 ? last.length : found;
      const before = last[lane];
      if (before) {
        before.next_s = item.start_s;
      }
      const placed = { ...item, lane: first + lane, next_s: Infinity };
      last[lane] = placed;
      return placed;
    });
}

/** @param {Performance} performance */
function wordItems({ words }) {
  const items = words.flatMap(({ index, text, start_s, end_s }) => within(`word:${String(index)}`, text, start_s, end_s));
  return inLanes(items.map(withEdges), 0).map((item) => ({ ...item, lane: 0 }));
}

/**
 * A word with its edges as marks, by which it is dragged.
 *
 * @param {Loose} item
 * @returns {Loose}
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
    within(each.id, plain(functionName(each)), each.start_s, each.end_s).map((item) => ({
      ...item,
      technical: [each.class, each.subtype].filter(Boolean).join("."),
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
    label: [movementName(kind, lexeme), handName(hand)].filter(Boolean).join(", "),
    technical: hand ? `${lexeme} (${hand})` : lexeme,
    start_s: Math.min(...times_s),
    end_s: Math.max(...times_s),
    kept,
    marks,
    phases: kind === "gesture" ? phasesOf(sync) : [],
    why: kept ? "" : plainText([reason, lostTo && `gave way to ${lostTo}`].filter(Boolean).join("; ")),
  };
}
