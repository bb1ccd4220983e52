/** Feelings that are heard in a voice, each with its share. */

/**
 * The tone that a voice has most of, and how much.
 *
 * @param {Readonly<Record<string, number>>} tones
 * @returns {readonly [string, number]}
 */
export function strongest(tones) {
  const ordered = Object.entries(tones).sort(([, one], [, other]) => other - one);
  return ordered[0] ?? ["neutral", 1];
}
