/** Samples as a WAV file: one channel, 16 bits. */

const HEADER_BYTES = 44;
const LOUDEST = 32767;

/**
 * @param {Float32Array} samples from -1 to 1; what is louder is clipped
 * @param {number} rate_hz
 * @returns {Uint8Array<ArrayBuffer>}
 */
export function wavOf(samples, rate_hz) {
  const bytes = new Uint8Array(HEADER_BYTES + 2 * samples.length);
  const view = new DataView(bytes.buffer);
  const text = (/** @type {number} */ at, /** @type {string} */ said) => bytes.set(new TextEncoder().encode(said), at);
  text(0, "RIFF");
  view.setUint32(4, bytes.length - 8, true);
  text(8, "WAVEfmt ");
  view.setUint32(16, 16, true);
  view.setUint16(20, 1, true);
  view.setUint16(22, 1, true);
  view.setUint32(24, rate_hz, true);
  view.setUint32(28, 2 * rate_hz, true);
  view.setUint16(32, 2, true);
  view.setUint16(34, 16, true);
  text(36, "data");
  view.setUint32(40, 2 * samples.length, true);
  samples.forEach((sample, index) => view.setInt16(HEADER_BYTES + 2 * index, Math.round(Math.max(-1, Math.min(1, sample)) * LOUDEST), true));
  return bytes;
}
