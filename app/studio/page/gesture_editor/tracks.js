/**
 * Changes of a gesture's offset tracks, each of which leaves tracks that make sense: they turn something, and only those
 * that circle have turns. Values are never changed in place.
 */

/** @import { GestureLanguage, GestureTrack, GestureValues } from "understudy-client" */

/** The track that another one begins as: the body turns a little with the gesture. @type {GestureTrack} */
const FIRST_TRACK = { form: "held", joint: "chest", degrees: [0, 10, 0], turns: 0, phase_deg: 0 };
const USUAL_TURNS = 1;

/**
 * The tracks of a gesture.
 *
 * @param {GestureValues} gesture
 * @returns {readonly GestureTrack[]}
 */
export function tracksOf(gesture) {
  return gesture.tracks ?? [];
}

/**
 * @param {GestureValues} gesture
 * @returns {GestureValues}
 */
export function withTrackAdded(gesture) {
  return { ...gesture, tracks: [...tracksOf(gesture), FIRST_TRACK] };
}

/**
 * @param {GestureValues} gesture
 * @param {number} index
 * @returns {GestureValues}
 */
export function withoutTrack(gesture, index) {
  return { ...gesture, tracks: tracksOf(gesture).filter((_, at) => at !== index) };
}

/**
 * The gesture with another track at a place, within the language's ranges; the same gesture where it would turn nothing.
 *
 * @param {GestureLanguage} language
 * @param {GestureValues} gesture
 * @param {number} index
 * @param {Partial<GestureTrack>} keys
 * @returns {GestureValues}
 */
export function withTrack(language, gesture, index, keys) {
  const before = tracksOf(gesture)[index];
  const changed = before && possibleTrack(language, { ...before, ...keys });
  if (!changed?.degrees.some((angle) => angle !== 0)) {
    return gesture;
  }
  return { ...gesture, tracks: tracksOf(gesture).map((track, at) => (at === index ? changed : track)) };
}

/**
 * @param {GestureLanguage} language
 * @param {GestureTrack} track
 * @returns {GestureTrack}
 */
function possibleTrack({ ranges }, track) {
  const within = (/** @type {string} */ name, /** @type {number} */ value) => {
    const [least, most] = ranges[name] ?? [value, value];
    return Math.min(Math.max(value, least), most);
  };
  const [x, y, z] = track.degrees;
  const isCircling = track.form === "circling";
  return {
    ...track,
    degrees: [within("track_degrees", x), within("track_degrees", y), within("track_degrees", z)],
    turns: isCircling ? within("track_turns", track.turns || USUAL_TURNS) : 0,
    phase_deg: isCircling ? within("track_phase_deg", track.phase_deg ?? 0) : 0,
  };
}
