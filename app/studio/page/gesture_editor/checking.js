/**
 * Keeps text and motion those of the gestures: whenever they change, the service writes and checks them, and plays the
 * one that is edited. A text that the author wrote is kept as it is until he changes a value.
 */

import { clipFromJson } from "understudy-client";

import { latest } from "../service/latest.js";
import { problemOf } from "../service/service.js";
import { PROBLEM } from "../state/performed.js";
import { slice } from "../state/slice.js";
import { ChangeGestures, CHECKED, EDITED, FRAME, gestureOf, LANGUAGE } from "./gestures.js";

/** @import { CheckedGestures, Clip, GestureLanguage, GestureValues } from "understudy-client" */
/** @import { Service } from "../service/service.js" */
/** @import { Store } from "../state/store.js" */

/** @typedef {"low" | "medium" | "high"} Level */

/** How the gesture is played. @typedef {Readonly<{ level: Level, playing: boolean }>} Preview */

export const PREVIEW = slice(/** @type {Preview} */ ({ level: "medium", playing: false }));

/** The gesture that is edited, and its motion at a level; null until there is one. */
export const MOTION = slice(/** @type {Readonly<{ gesture: GestureValues, level: string, clip: Clip }> | null} */ (null));

/** The gestures that were checked last: from the text that the author wrote or opened, or by their values. */
const SOURCE = slice(/** @type {Readonly<{ gestures: readonly GestureValues[], checked: CheckedGestures }> | null} */ (null));

/** What the author writes and nobody has checked yet; null if that is nothing. */
export const TYPED = slice(/** @type {string | null} */ (null));

const JSON_TYPE = "application/json";

/**
 * @param {Store} store
 * @param {Service} service
 */
export function keepChecked(store, service) {
  const refresh = latest((isLatest) => updated(store, service, isLatest));
  for (const of of [EDITED, PREVIEW]) {
    store.watch(/** @type {typeof PREVIEW} */ (of), () => void refresh());
  }
}

/**
 * @param {Store} store
 * @param {Service} service
 * @param {() => boolean} isLatest
 */
async function updated(store, service, isLatest) {
  try {
    const { gestures } = store.get(EDITED);
    if (store.get(SOURCE)?.gestures !== gestures) {
      store.set(SOURCE, { gestures, checked: await check(service, { gestures }) });
    }
    if (isLatest()) {
      store.set(CHECKED, store.get(SOURCE)?.checked ?? null);
      await play(store, service);
    }
  } catch (error) {
    store.set(PROBLEM, problemOf(error));
  }
}

/**
 * Takes over a text that the author wrote, or what `asked` finds in the library: with mistakes it is told, without it is
 * what is edited.
 *
 * @param {Store} store
 * @param {Service} service
 * @param {Readonly<{ text: string } | { library: string }>} asked
 */
export async function takeText(store, service, asked) {
  try {
    const checked = await check(service, asked);
    if ("text" in asked && asked.text === store.get(TYPED)) {
      store.set(TYPED, null);
    }
    const { gestures } = checked;
    if (checked.mistakes.length > 0 || gestures.length === 0) {
      store.set(CHECKED, checked);
      return;
    }
    store.set(SOURCE, { gestures, checked });
    const index = Math.min(store.get(EDITED).index, gestures.length - 1);
    store.history.execute(new ChangeGestures(store, "Text of gestures", { gestures, index }));
    store.set(FRAME, Math.min(store.get(FRAME), gestureOf(store.get(EDITED)).frames.length - 1));
    store.set(CHECKED, checked);
  } catch (error) {
    store.set(PROBLEM, problemOf(error));
  }
}

/**
 * The text of what is edited now, whether it was checked since the last change or not; null if nobody can say.
 *
 * @param {Store} store
 * @param {Service} service
 */
export async function textNow(store, service) {
  const { gestures } = store.get(EDITED);
  const source = store.get(SOURCE);
  try {
    const last = source?.gestures === gestures ? (store.get(CHECKED) ?? source.checked) : await check(service, { gestures });
    return store.get(TYPED) ?? last.text;
  } catch (error) {
    store.set(PROBLEM, problemOf(error));
    return null;
  }
}

/**
 * Asks for the words of the language, once.
 *
 * @param {Store} store
 * @param {Service} service
 */
export async function askLanguage(store, service) {
  try {
    const answer = await service.fetch("gestures/language");
    store.set(LANGUAGE, /** @type {GestureLanguage} */ (await answer.json()));
  } catch (error) {
    store.set(PROBLEM, problemOf(error));
  }
}

/**
 * @param {Service} service
 * @param {object} asked
 * @returns {Promise<CheckedGestures>}
 */
async function check(service, asked) {
  const answer = await service.fetch("gestures/check", posted(asked));
  return /** @type {CheckedGestures} */ (await answer.json());
}

/** What is played: it is not asked for again until it is another. */
const PLAYED = slice("");

/**
 * @param {Store} store
 * @param {Service} service
 */
async function play(store, service) {
  const checked = store.get(CHECKED);
  const gesture = gestureOf(store.get(EDITED));
  const isPlayable = checked?.mistakes.length === 0 && checked.gestures.some(({ name }) => name === gesture.name);
  if (!isPlayable) {
    return;
  }
  const known = Object.keys(gesture.levels);
  const { level: wanted } = store.get(PREVIEW);
  const level = known.includes(wanted) ? wanted : (known[0] ?? wanted);
  const asked = JSON.stringify({ text: checked.text, name: gesture.name, level, fps: 60 });
  if (store.get(PLAYED) !== asked) {
    const answer = await service.fetch("gestures/motion", posted(JSON.parse(asked)));
    store.set(PLAYED, asked);
    store.set(MOTION, { gesture, level, clip: clipFromJson(await answer.json()) });
  }
}

/** @param {object} content */
function posted(content) {
  return { method: "POST", headers: { "content-type": JSON_TYPE, accept: JSON_TYPE }, body: JSON.stringify(content) };
}
