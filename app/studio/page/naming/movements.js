/** What people call movements and the parts of the body that make them. Tooltips have the technical names. */

import { GESTURES } from "./gesture_names.js";

/** @type {Readonly<Record<string, Readonly<Record<string, string>>>>} */
const NAMES = Object.freeze({
  gesture: GESTURES,
  head: {
    BOW: "Bow the head", CHIN_RAISE: "Raise the chin", LOWER: "Lower the head", NOD: "Nod", RAISE: "Raise the head",
    SHAKE: "Shake the head", SWAY: "Sway the head", TILT_LEFT: "Tilt the head left",
    TILT_LEFT_NOD: "Tilt left and nod", TILT_RIGHT: "Tilt the head right", TILT_RIGHT_NOD: "Tilt right and nod",
    TOSS: "Toss the head", TURN_LEFT: "Turn the head left", TURN_RIGHT: "Turn the head right",
  },
  gaze: {
    GLANCE: "Glance", LOOK: "Look away", SHIFT: "Look over",
  },
  face: {
    DIMPLE: "Dimple", LOWER_BROWS: "Frown", LOWER_MOUTH_CORNERS: "Mouth corners down",
    NARROW_EYES: "Narrow the eyes", OBLIQUE_BROWS: "Worried brows", OPEN_LIPS: "Open the lips",
    PRESS_LIPS: "Press the lips", RAISE_BROWS: "Raise the brows", RAISE_CHEEKS: "Raise the cheeks",
    RAISE_LEFT_MOUTH_CORNER: "Half smile", RAISE_MOUTH_CORNERS: "Smile", RAISE_RIGHT_BROW: "Raise one brow",
    STRETCH_LIPS: "Stretch the lips", WIDEN_EYES: "Widen the eyes", WRINKLE_NOSE: "Wrinkle the nose",
  },
  eyes: {
    BLINK: "Blink",
  },
  posture: {
    ARMS_OPEN: "Arms open", HANDS_BEHIND_BACK: "Hands behind the back", HANDS_FOLDED: "Hands folded",
    HANDS_ON_HIPS: "Hands on hips", LEAN_BACK: "Lean back", LEAN_FORWARD: "Lean forward", LEAN_LEFT: "Lean left",
    LEAN_RIGHT: "Lean right", STRAIGHTEN: "Straighten up", WEIGHT_ON_LEFT_LEG: "Weight on the left leg",
    WEIGHT_ON_RIGHT_LEG: "Weight on the right leg",
  },
});

/** @type {Readonly<Record<string, string>>} */
const CHANNELS = Object.freeze({
  words: "Words", phones: "Sounds", voice: "Voice", feeling: "Feeling", focus: "Focus", gesture: "Gestures", head: "Head", gaze: "Gaze",
  face: "Face", eyes: "Eyes", posture: "Posture", functions: "Meaning", visemes: "Lips", compared: "Compared",
});

/** @type {Readonly<Record<string, string>>} */
const HANDS = Object.freeze({ left: "left hand", right: "right hand", both: "both hands" });

/**
 * @param {string} kind the channel
 * @param {string} lexeme
 */
export function movementName(kind, lexeme) {
  return NAMES[kind]?.[lexeme] ?? plain(lexeme.replace(/^MIME_/, ""));
}

/** @param {string} channel */
export function channelName(channel) {
  return CHANNELS[channel] ?? plain(channel);
}

/** How agitated a voice or a gesture is, by the names of the service. @type {readonly (readonly [level: string, name: string])[]} */
export const AGITATION = Object.freeze([["low", "Calm"], ["medium", "Lively"], ["high", "Agitated"]]);

/** @param {string | null | undefined} hand */
export function handName(hand) {
  return hand ? (HANDS[hand] ?? hand) : "";
}

/**
 * A technical name in plain letters: `WAVE_OFF` is "Wave off".
 *
 * @param {string} name
 */
export function plain(name) {
  const words = name.replaceAll(/[_.]+/g, " ").trim().toLowerCase();
  return words.charAt(0).toUpperCase() + words.slice(1);
}

/**
 * A text of the service with lexemes and families in plain words.
 *
 * @param {string} text
 */
export function plainText(text) {
  const named = text.replaceAll(/\b[A-Z][A-Z]+(?:_[A-Z]+)*\b/g, (lexeme) => `“${anyName(lexeme)}”`);
  return named.replaceAll(/ ?\([^()]*log-odds\)/g, "").replaceAll(/\b([a-z]+)_([a-z_]+)\b/g, (word) => plain(word).toLowerCase());
}

/** @param {string} lexeme */
function anyName(lexeme) {
  return Object.values(NAMES).flatMap((names) => names[lexeme] ?? [])[0] ?? plain(lexeme);
}
