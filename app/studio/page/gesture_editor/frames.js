/** Changes of a gesture's frames, each of which leaves a gesture that makes sense. Values are never changed in place. */

import { orientationOf, partnersOf, roomBehind, thumbsOf, timesAt, typesAt } from "./possible.js";

/** @import { GestureArm, GestureFrame, GestureLanguage, GestureValues } from "understudy-client" */

/** @typedef {"leading" | "other"} ArmName */

/**
 * The gesture with another frame at a place.
 *
 * @param {GestureValues} gesture
 * @param {number} index
 * @param {Partial<GestureFrame>} keys
 * @returns {GestureValues}
 */
export function withFrame(gesture, index, keys) {
  return { ...gesture, frames: gesture.frames.map((frame, at) => (at === index ? { ...frame, ...keys } : frame)) };
}

/**
 * With other parts of an arm in a frame; what is undefined is left open. An arm that says nothing any more is the mirror
 * image, if it is the other one.
 *
 * @param {GestureValues} gesture
 * @param {number} index
 * @param {ArmName} name
 * @param {{ [Part in keyof GestureArm]: GestureArm[Part] | undefined }} parts
 * @returns {GestureValues}
 */
export function withArm(gesture, index, name, parts) {
  const merged = Object.entries({ ...gesture.frames[index]?.[name], ...parts });
  const arm = /** @type {GestureArm} */ (Object.fromEntries(merged.filter(([, value]) => !isOpen(value))));
  const says = name === "leading" || Object.keys(arm).length > 0;
  return withFrame(gesture, index, { [name]: says ? arm : null });
}

/**
 * With the frame at a time, as near as its neighbours let it.
 *
 * @param {GestureValues} gesture
 * @param {number} index
 * @param {number} time
 */
export function withTime(gesture, index, time) {
  const [least, most] = timesAt(gesture.frames, index);
  return withFrame(gesture, index, { time: Math.min(Math.max(Math.round(time * 1000) / 1000, least), most) });
}

/**
 * With another frame behind one: the same pose, of the first type that can be there. The same gesture where there is no
 * room.
 *
 * @param {GestureLanguage} language
 * @param {GestureValues} gesture
 * @param {number} index
 * @returns {GestureValues}
 */
export function withFrameBehind(language, gesture, index) {
  const frame = gesture.frames[index];
  const room = roomBehind(language, gesture.frames, index);
  if (!room || !frame) {
    return gesture;
  }
  const type = /** @type {GestureFrame["type"]} */ (room.types.find((each) => each !== frame.type) ?? room.types[0]);
  const added = { ...frame, time: room.time, type };
  return { ...gesture, frames: gesture.frames.toSpliced(index + 1, 0, added) };
}

/**
 * Whether a gesture makes sense without one of its frames: the stroke stays, and the first frame places the arm.
 *
 * @param {readonly GestureFrame[]} frames
 * @param {number} index
 */
export function canBeWithout(frames, index) {
  const left = frames.toSpliced(index, 1);
  const last = left.findLastIndex(({ type }) => type === "stroke" || type === "stroke_end");
  return last > 0 && Boolean(left[0]?.leading.place);
}

/**
 * @param {GestureValues} gesture
 * @param {number} index
 */
export function withoutFrame(gesture, index) {
  return canBeWithout(gesture.frames, index) ? { ...gesture, frames: gesture.frames.toSpliced(index, 1) } : gesture;
}

/**
 * With a form of the hand, whose thumb stays if the form leaves it free.
 *
 * @param {GestureLanguage} language
 * @param {NonNullable<GestureArm["hand"]>} hand
 * @returns {NonNullable<GestureArm["hand"]>}
 */
export function possibleHand(language, { form, thumb = "default" }) {
  return { form, thumb: thumbsOf(language, form).includes(thumb) ? thumb : "default" };
}

/**
 * With one of the wrist's two directions, if it is at a right angle to the other; else as it was.
 *
 * @param {GestureLanguage} language
 * @param {NonNullable<GestureArm["wrist"]>} wrist
 * @param {Partial<NonNullable<GestureArm["wrist"]>>} changed
 */
export function possibleWrist(language, wrist, changed) {
  const made = { ...wrist, ...changed };
  return partnersOf(language, made.finger_base).has(orientationOf(language, made.palm)) ? made : wrist;
}

/**
 * With a type, if it can be there; else as it was.
 *
 * @param {GestureLanguage} language
 * @param {GestureValues} gesture
 * @param {number} index
 * @param {string} type
 */
export function withType(language, gesture, index, type) {
  const possible = typesAt(language, gesture.frames, index).includes(type);
  return possible ? withFrame(gesture, index, { type: /** @type {GestureFrame["type"]} */ (type) }) : gesture;
}

/** @param {unknown} value */
function isOpen(value) {
  return value === undefined || value === null || (typeof value === "object" && Object.keys(value).length === 0);
}
