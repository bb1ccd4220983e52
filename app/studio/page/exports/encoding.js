/**
 * A film that is drawn frame by frame (WebCodecs, VP8 and Opus): a slow machine takes longer and leaves nothing out. Times
 * are those of the frames, not of the clock.
 */

import { breath } from "./taking.js";
import { webm } from "./webm.js";

/** @import { Telling } from "./taking.js" */
/** @import { Chunk } from "./webm.js" */

/** What a film is of: `draw` draws the canvas as it is at a time; the sound, if there is one, begins at `heard_s`. @typedef {Readonly<{ canvas: HTMLCanvasElement | OffscreenCanvas, draw: (time_s: number) => void, length_s: number, sound: AudioBuffer | null, heard_s: number }>} Shooting */

export const FILM_HZ = 30;
export const SOUND_HZ = 48_000;
const KEY_EVERY = 60;
/** How many frames wait to be encoded at most: each is 8 MB. */
const MOST_WAITING = 4;
const SOUND_STEP = 4800;
const US = 1e6;

/** @param {{ width: number, height: number }} size */
function videoConfig({ width, height }) {
  return /** @type {VideoEncoderConfig} */ ({ codec: "vp8", width, height, bitrate: 8_000_000, framerate: FILM_HZ });
}

/** @param {AudioBuffer} sound */
function audioConfig({ numberOfChannels, sampleRate }) {
  return { codec: "opus", numberOfChannels, sampleRate, bitrate: 128_000 };
}

/**
 * Whether the browser encodes such pictures and, if there is one, the sound.
 *
 * @param {{ width: number, height: number }} size
 * @param {AudioBuffer | null} sound
 */
export async function canEncode(size, sound) {
  if (!("VideoEncoder" in globalThis) || (sound && !("AudioEncoder" in globalThis))) {
    return false;
  }
  const asked = [VideoEncoder.isConfigSupported(videoConfig(size)), ...(sound ? [AudioEncoder.isConfigSupported(audioConfig(sound))] : [])];
  return (await Promise.all(asked)).every(({ supported }) => supported);
}

/**
 * @param {Shooting} shooting
 * @param {Telling} tell
 * @returns {Promise<Blob>}
 */
export async function encodedFilm(shooting, tell) {
  const { canvas, sound, heard_s, length_s } = shooting;
  const heard = sound && { rate_hz: sound.sampleRate, channels: sound.numberOfChannels, ...(await encodedSound(sound, heard_s)) };
  const chunks = await encodedPictures(shooting, tell);
  return webm({ width_px: canvas.width, height_px: canvas.height, chunks }, heard, length_s);
}

/**
 * @param {Shooting} shooting
 * @param {Telling} tell
 */
async function encodedPictures({ canvas, draw, length_s }, tell) {
  /** @type {Chunk[]} */
  const chunks = [];
  const { encoder, failed } = following((/** @type {(error: DOMException) => void} */ error) => new VideoEncoder({ output: (chunk) => chunks.push(chunkOf(chunk)), error }));
  encoder.configure(videoConfig(canvas));
  const count = Math.ceil(length_s * FILM_HZ);
  try {
    for (let place = 0; place < count; place++) {
      draw(place / FILM_HZ);
      const frame = new VideoFrame(canvas, { timestamp: Math.round((place * US) / FILM_HZ), duration: Math.round(US / FILM_HZ) });
      encoder.encode(frame, { keyFrame: place % KEY_EVERY === 0 });
      frame.close();
      tell((place + 1) / count);
      await Promise.race([roomIn(encoder), failed]);
      await breath();
    }
    await Promise.race([encoder.flush(), failed]);
  } finally {
    if (encoder.state !== "closed") {
      encoder.close();
    }
  }
  return chunks;
}

/**
 * @param {AudioBuffer} sound
 * @param {number} heard_s
 */
async function encodedSound(sound, heard_s) {
  /** @type {Chunk[]} */
  const chunks = [];
  let head = new Uint8Array();
  /** @type {EncodedAudioChunkOutputCallback} */
  const output = (chunk, told) => {
    const description = told?.decoderConfig?.description;
    if (description) {
      head = new Uint8Array(ArrayBuffer.isView(description) ? description.buffer : description).slice();
    }
    chunks.push(chunkOf(chunk));
  };
  const { encoder, failed } = following((/** @type {(error: DOMException) => void} */ error) => new AudioEncoder({ output, error }));
  encoder.configure(audioConfig(sound));
  for (let from = 0; from < sound.length; from += SOUND_STEP) {
    const data = piece(sound, from, heard_s);
    encoder.encode(data);
    data.close();
  }
  await Promise.race([encoder.flush(), failed]);
  encoder.close();
  return { head, chunks };
}

/**
 * @param {AudioBuffer} sound
 * @param {number} from
 * @param {number} heard_s
 */
function piece(sound, from, heard_s) {
  const { numberOfChannels, sampleRate, length } = sound;
  const numberOfFrames = Math.min(SOUND_STEP, length - from);
  const data = new Float32Array(numberOfFrames * numberOfChannels);
  for (let channel = 0; channel < numberOfChannels; channel++) {
    data.set(sound.getChannelData(channel).subarray(from, from + numberOfFrames), channel * numberOfFrames);
  }
  const timestamp = Math.round((heard_s + from / sampleRate) * US);
  return new AudioData({ format: "f32-planar", sampleRate, numberOfFrames, numberOfChannels, timestamp, data });
}

/**
 * An encoder, and what rejects as soon as it fails.
 *
 * @template Encoder
 * @param {(failed: (error: DOMException) => void) => Encoder} make
 */
function following(make) {
  /** @type {(error: DOMException) => void} */
  let fail = () => undefined;
  const failed = new Promise((/** @type {(value: never) => void} */ _resolve, reject) => (fail = reject));
  failed.catch(() => undefined);
  return { encoder: make((error) => fail(error)), failed };
}

/** @param {VideoEncoder} encoder */
async function roomIn(encoder) {
  while (encoder.encodeQueueSize > MOST_WAITING) {
    await new Promise((resolve) => encoder.addEventListener("dequeue", resolve, { once: true }));
  }
}

/**
 * @param {EncodedVideoChunk | EncodedAudioChunk} chunk
 * @returns {Chunk}
 */
function chunkOf(chunk) {
  const data = new Uint8Array(chunk.byteLength);
  chunk.copyTo(data);
  return { time_us: chunk.timestamp, isKey: chunk.type === "key", data };
}
