/** Draws what is heard: the wave, and below it energy and f0, stress thresholds and how the words stand out. */

import { slice } from "../state/slice.js";
import { WORDS_PX } from "./layout.js";

/** @import { Performance } from "understudy-client" */
/** @import { Contours } from "../state/performed.js" */
/** @import { Pen, Picture } from "./drawing.js" */
/** @import { PlacedRow } from "./layout.js" */

/**
 * `peaks` are the greatest amplitudes, PEAKS_HZ a second from the start of the recording.
 *
 * @typedef {Readonly<{ peaks: Float32Array, contours: Contours | null, performance: Performance }>} Signals
 */

export const PEAKS_HZ = 400;
const F0_ROOM = 1.1;
const QUIETEST_DB = -50;

/** The recording's greatest amplitudes; none until it is decoded. */
export const PEAKS = slice(new Float32Array());

/**
 * The peaks of a recording. Rejects where the browser cannot decode it.
 *
 * @param {Blob} recording
 */
export async function peaksOf(recording) {
  const decoder = new OfflineAudioContext(1, 1, 44100);
  const decoded = await decoder.decodeAudioData(await recording.arrayBuffer());
  const samples = decoded.getChannelData(0);
  const step = decoded.sampleRate / PEAKS_HZ;
  const peaks = new Float32Array(Math.ceil(samples.length / step));
  for (const [index, sample] of samples.entries()) {
    const at = Math.floor(index / step);
    peaks[at] = Math.max(peaks[at] ?? 0, Math.abs(sample));
  }
  return peaks;
}

/**
 * @param {Pen} pen
 * @param {Picture} picture
 * @param {PlacedRow} placedRow
 */
export function drawWave(pen, { axis, palette, signals }, { top_px, height_px }) {
  const { peaks, performance } = signals;
  const middle = top_px + (height_px - WORDS_PX) / 2;
  const loudest = peaks.reduce((most, peak) => Math.max(most, peak), 0.01);
  pen.fillStyle = palette.wave;
  for (let x = axis.left_px; x < axis.left_px + axis.width_px; x++) {
    const first = Math.floor((axis.time_s(x) - performance.lead_in_s) * PEAKS_HZ);
    const last = Math.max(first + 1, Math.floor((axis.time_s(x + 1) - performance.lead_in_s) * PEAKS_HZ));
    const peak = peaks.subarray(Math.max(0, first), Math.max(0, last)).reduce((most, each) => Math.max(most, each), 0);
    const half = (peak / loudest) * ((height_px - WORDS_PX - 2) / 2);
    pen.fillRect(x, middle - half, 1, 2 * half);
  }
}

/**
 * @param {Pen} pen
 * @param {Picture} picture
 * @param {PlacedRow} placedRow
 */
export function drawVoice(pen, picture, placedRow) {
  drawEmphasis(pen, picture, placedRow);
  const { contours, performance } = picture.signals;
  if (contours) {
    const loudest = contours.energy_db.reduce((most, each) => Math.max(most, each), QUIETEST_DB);
    const share = (/** @type {number} */ db) => Math.max(0, 1 - (loudest - db) / -QUIETEST_DB);
    drawCurve(pen, picture, placedRow, { values: contours.energy_db, share, colour: picture.palette.energy });
    const voiced_hz = contours.f0_hz.filter((hz) => hz > 0);
    const [lowest_hz, highest_hz] = [Math.min(...voiced_hz) / F0_ROOM, Math.max(...voiced_hz) * F0_ROOM];
    const f0Share = (/** @type {number} */ hz) => (hz > 0 ? Math.log(hz / lowest_hz) / Math.log(highest_hz / lowest_hz) : 0);
    drawCurve(pen, picture, placedRow, { values: contours.f0_hz, share: f0Share, colour: picture.palette.f0 });
    drawThreshold(pen, picture, placedRow, f0Share(performance.stress?.f0_hz ?? 0));
  }
}

/**
 * How much each word stands out, as bars from the bottom.
 *
 * @param {Pen} pen
 * @param {Picture} picture
 * @param {PlacedRow} placedRow
 */
function drawEmphasis(pen, { axis, palette, signals }, { top_px, height_px }) {
  pen.fillStyle = palette.stress;
  for (const { start_s, end_s, emphasis } of signals.performance.words) {
    if (typeof start_s === "number" && typeof end_s === "number" && emphasis) {
      const height = Math.min(1, emphasis) * height_px;
      pen.fillRect(axis.px(start_s), top_px + height_px - height, axis.px(end_s) - axis.px(start_s), height);
    }
  }
}

/**
 * A curve over frames; nothing is drawn where its share is 0.
 *
 * @param {Pen} pen
 * @param {Picture} picture
 * @param {PlacedRow} placedRow
 * @param {Readonly<{ values: readonly number[], share: (value: number) => number, colour: string }>} curve
 */
function drawCurve(pen, { axis, signals }, { top_px, height_px }, { values, share, colour }) {
  const { lead_in_s } = signals.performance;
  const shift_s = signals.contours?.frame_shift_s ?? 0;
  const first = Math.max(0, Math.floor((axis.stretch.start_s - lead_in_s) / shift_s));
  const last = Math.ceil((axis.stretch.start_s + axis.stretch.length_s - lead_in_s) / shift_s);
  pen.strokeStyle = colour;
  pen.beginPath();
  let isOn = false;
  for (const [index, value] of values.slice(first, last).entries()) {
    const height = share(value);
    const x = axis.px(lead_in_s + (first + index) * shift_s);
    const y = top_px + height_px * (1 - height);
    pen[isOn ? "lineTo" : "moveTo"](x, y);
    isOn = height > 0;
  }
  pen.stroke();
}

/**
 * @param {Pen} pen
 * @param {Picture} picture
 * @param {PlacedRow} placedRow
 * @param {number} share
 */
function drawThreshold(pen, { axis, palette }, { top_px, height_px }, share) {
  const y = top_px + height_px * (1 - share);
  pen.strokeStyle = palette.f0;
  pen.setLineDash([3, 4]);
  pen.beginPath();
  pen.moveTo(axis.left_px, y);
  pen.lineTo(axis.left_px + axis.width_px, y);
  pen.stroke();
  pen.setLineDash([]);
}
