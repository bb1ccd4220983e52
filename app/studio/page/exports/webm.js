/**
 * Encoded pictures and sound as a WebM file (Matroska, RFC 9559; webmproject.org/docs/container): one track of pictures, at
 * most one of sound, in clusters that begin at key frames, with cues to seek by. Times of chunks are in microseconds.
 */

/** @typedef {Readonly<{ time_us: number, isKey: boolean, data: Uint8Array }>} Chunk */
/** @typedef {Readonly<{ width_px: number, height_px: number, chunks: readonly Chunk[] }>} Pictures VP8 */
/** @typedef {Readonly<{ rate_hz: number, channels: number, head: Uint8Array, chunks: readonly Chunk[] }>} Sound Opus with its OpusHead (RFC 7845) */
/** @typedef {Readonly<{ track: number, chunk: Chunk }>} Block */

const [PICTURES, SOUND] = [1, 2];
const PRE_ROLL_NS = 80_000_000;
const US_IN_MS = 1000;
const OPUS_HZ = 48_000;

/**
 * @param {Pictures} pictures
 * @param {Sound | null} sound
 * @param {number} length_s
 */
export function webm(pictures, sound, length_s) {
  const info = element(0x1549a966, [uint(0x2ad7b1, 1_000_000), float(0x4489, length_s * 1000), text(0x4d80, "Understudy"), text(0x5741, "Understudy")]);
  const tracks = element(0x1654ae6b, [pictureTrack(pictures), ...(sound ? [soundTrack(sound)] : [])]);
  const clusters = clustersOf(pictures, sound);
  let place = info.length + tracks.length;
  const cues = clusters.map(({ start_ms, bytes }) => {
    const at = element(0xb7, [uint(0xf7, PICTURES), uint(0xf1, place)]);
    place += bytes.length;
    return element(0xbb, [uint(0xb3, start_ms), at]);
  });
  const segment = element(0x18538067, [info, tracks, ...clusters.map(({ bytes }) => bytes), element(0x1c53bb6b, cues)]);
  return new Blob([header(), segment], { type: "video/webm" });
}

function header() {
  return element(0x1a45dfa3, [uint(0x4286, 1), uint(0x42f7, 1), uint(0x42f2, 4), uint(0x42f3, 8), text(0x4282, "webm"), uint(0x4287, 4), uint(0x4285, 2)]);
}

/** @param {Pictures} pictures */
function pictureTrack({ width_px, height_px }) {
  const size = element(0xe0, [uint(0xb0, width_px), uint(0xba, height_px)]);
  return element(0xae, [uint(0xd7, PICTURES), uint(0x73c5, PICTURES), uint(0x83, 1), text(0x86, "V_VP8"), size]);
}

/** @param {Sound} sound */
function soundTrack({ rate_hz, channels, head }) {
  const preSkip = new DataView(head.buffer, head.byteOffset).getUint16(10, true);
  const heard = element(0xe1, [float(0xb5, rate_hz), uint(0x9f, channels)]);
  const delay = [uint(0x56aa, Math.round((preSkip / OPUS_HZ) * 1e9)), uint(0x56bb, PRE_ROLL_NS)];
  return element(0xae, [uint(0xd7, SOUND), uint(0x73c5, SOUND), uint(0x83, 2), text(0x86, "A_OPUS"), element(0x63a2, [head]), ...delay, heard]);
}

/**
 * Everything in the order of its time, in clusters from one key frame to the next.
 *
 * @param {Pictures} pictures
 * @param {Sound | null} sound
 */
function clustersOf(pictures, sound) {
  const blocks = [
    ...pictures.chunks.map((chunk) => ({ track: PICTURES, chunk })),
    ...(sound?.chunks ?? []).map((chunk) => ({ track: SOUND, chunk })),
  ].sort((one, other) => one.chunk.time_us - other.chunk.time_us || one.track - other.track);
  /** @type {Block[][]} */
  const groups = [];
  for (const block of blocks) {
    const isFirst = groups.length === 0 || (block.track === PICTURES && block.chunk.isKey);
    if (isFirst) {
      groups.push([]);
    }
    groups.at(-1)?.push(block);
  }
  return groups.map(cluster);
}

/** @param {readonly Block[]} blocks */
function cluster(blocks) {
  const start_ms = Math.round((blocks[0]?.chunk.time_us ?? 0) / US_IN_MS);
  const simple = blocks.map(({ track, chunk: { time_us, isKey, data } }) => {
    const head = new Uint8Array(4);
    const view = new DataView(head.buffer);
    view.setUint8(0, 0x80 | track);
    view.setInt16(1, Math.round(time_us / US_IN_MS) - start_ms);
    view.setUint8(3, isKey ? 0x80 : 0);
    return element(0xa3, [head, data]);
  });
  return { start_ms, bytes: element(0x1f43b675, [uint(0xe7, start_ms), ...simple]) };
}

/**
 * An element with its size in eight bytes.
 *
 * @param {number} id
 * @param {readonly Uint8Array[]} parts
 */
function element(id, parts) {
  const name = bytesOf(id);
  const length = parts.reduce((sum, part) => sum + part.length, 0);
  const made = new Uint8Array(name.length + 8 + length);
  made.set(name);
  new DataView(made.buffer).setBigUint64(name.length, (1n << 56n) | BigInt(length));
  let at = name.length + 8;
  for (const part of parts) {
    made.set(part, at);
    at += part.length;
  }
  return made;
}

/**
 * @param {number} id
 * @param {number} value
 */
function uint(id, value) {
  return element(id, [bytesOf(value)]);
}

/**
 * @param {number} id
 * @param {number} value
 */
function float(id, value) {
  const bytes = new Uint8Array(8);
  new DataView(bytes.buffer).setFloat64(0, value);
  return element(id, [bytes]);
}

/**
 * @param {number} id
 * @param {string} value
 */
function text(id, value) {
  return element(id, [new TextEncoder().encode(value)]);
}

/**
 * A whole number in as few bytes as hold it, the highest first.
 *
 * @param {number} value
 */
function bytesOf(value) {
  const digits = value.toString(16);
  const pairs = digits.padStart(digits.length + (digits.length % 2), "0").match(/../g) ?? [];
  return Uint8Array.from(pairs, (pair) => parseInt(pair, 16));
}
