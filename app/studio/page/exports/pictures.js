/**
 * What the stage shows, taken away as pictures: the frames of a film at 1920 × 1080, a sheet of stills as large as the stage.
 * Nothing that is selected is pointed out in them.
 */

import { zipSync } from "fflate";

import { FILM_HZ } from "./encoding.js";
import { large, resting, taken } from "./taking.js";

/** @import { Performance } from "understudy-client" */
/** @import { Store } from "../state/store.js" */
/** @import { Screen } from "../stage/viewing.js" */
/** @import { Telling } from "./taking.js" */

const MOST_STILLS = 12;
const COLUMNS = 4;
const LABEL_PX = 26;

/**
 * Frames as PNG in a zip, FILM_HZ a second, named as ffmpeg's %05d wants them.
 *
 * @param {Store} store
 * @param {Screen} screen
 * @param {number} length_s
 * @param {Telling} tell
 */
export async function frames(store, screen, length_s, tell) {
  const count = Math.ceil(length_s * FILM_HZ);
  /** @type {Record<string, Uint8Array>} */
  const files = {};
  await large(store, screen, async () => {
    for (let frame = 0; frame < count; frame++) {
      const picture = await taken(store, screen, frame / FILM_HZ);
      files[`${String(frame).padStart(5, "0")}.png`] = new Uint8Array(await picture.arrayBuffer());
      tell((frame + 1) / count);
    }
  });
  return new Blob([new Uint8Array(zipSync(files, { level: 0 }))], { type: "application/zip" });
}

/**
 * The strokes of the gestures side by side, with their times and words; of a line without any, equal steps.
 *
 * @param {Store} store
 * @param {Screen} screen
 * @param {Performance} performance
 */
export async function sheet(store, screen, performance) {
  const moments = momentsOf(performance);
  const { width, height } = screen.canvas;
  const columns = Math.min(COLUMNS, moments.length);
  const paper = new OffscreenCanvas(columns * width, Math.ceil(moments.length / columns) * (height + LABEL_PX));
  const pen = paper.getContext("2d");
  if (!pen) {
    throw new Error("the browser draws no pictures");
  }
  pen.fillStyle = "white";
  pen.fillRect(0, 0, paper.width, paper.height);
  pen.fillStyle = "black";
  pen.font = "16px system-ui, sans-serif";
  await resting(store, async () => {
    for (const [index, { time_s, label }] of moments.entries()) {
      const [x, y] = [(index % columns) * width, Math.floor(index / columns) * (height + LABEL_PX)];
      pen.drawImage(await createImageBitmap(await taken(store, screen, time_s)), x, y);
      pen.fillText(`${time_s.toFixed(2)} s  ${label}`, x + 6, y + height + 18, width - 12);
    }
  });
  return paper.convertToBlob({ type: "image/png" });
}

/**
 * @param {Performance} performance
 * @returns {{ time_s: number, label: string }[]}
 */
export function momentsOf({ behaviors, audio, lead_in_s }) {
  const strokes = behaviors
    .filter(({ kind, kept, sync }) => kind === "gesture" && kept && sync["stroke"] !== undefined)
    .map(({ lexeme, sync }) => ({ time_s: sync["stroke"] ?? 0, label: lexeme }));
  const steps = Array.from({ length: COLUMNS }, (_, index) => ({
    time_s: lead_in_s + (audio.duration_s * (index + 0.5)) / COLUMNS,
    label: "",
  }));
  return (strokes.length > 0 ? strokes : steps).slice(0, MOST_STILLS);
}
