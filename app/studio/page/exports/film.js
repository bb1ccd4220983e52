/**
 * The line as a film with its voice (WebM): drawn frame by frame where the browser encodes films (WebCodecs; over HTTPS or on this
 * machine), else recorded while the line is played, which a slow machine does not do frame by frame.
 */

import { PERFORMED, PLAYBACK, TIME_S } from "../state/performed.js";
import { isRecorded, PROJECT } from "../state/project.js";
import { canEncode, encodedFilm, SOUND_HZ } from "./encoding.js";
import { large, playedToTheEnd } from "./taking.js";

/** @import { Store } from "../state/store.js" */
/** @import { Screen } from "../stage/viewing.js" */
/** @import { Telling } from "./taking.js" */

const RECORDED_HZ = 60;

/**
 * @param {Store} store
 * @param {Screen} screen
 * @param {number} length_s
 * @param {Telling} tell
 */
export async function film(store, screen, length_s, tell) {
  const sound = await soundOf(store);
  const heard_s = store.get(PERFORMED)?.performance.lead_in_s ?? 0;
  const { canvas } = screen;
  const draw = (/** @type {number} */ time_s) => {
    store.set(TIME_S, time_s);
    screen.draw();
  };
  return large(store, screen, async () =>
    (await canEncode(canvas, sound)) ? encodedFilm({ canvas, draw, length_s, sound, heard_s }, tell) : recorded(store, screen, length_s, tell),
  );
}

/**
 * The recording; null where there is none, or none that the browser decodes (nor plays).
 *
 * @param {Store} store
 */
async function soundOf(store) {
  const { audio } = store.get(PROJECT);
  if (!audio || !isRecorded(audio)) {
    return null;
  }
  const decoder = new OfflineAudioContext(1, 1, SOUND_HZ);
  return decoder.decodeAudioData(await audio.arrayBuffer()).catch(() => null);
}

/**
 * The line as it is played once. It takes as long as the line.
 *
 * @param {Store} store
 * @param {Screen} screen
 * @param {number} length_s
 * @param {Telling} tell
 */
async function recorded(store, { canvas, audio }, length_s, tell) {
  const stream = canvas.captureStream(RECORDED_HZ);
  // Where the browser cannot tap the recording, the film is silent.
  const voice = /** @type {{ captureStream?: () => MediaStream }} */ (/** @type {unknown} */ (audio)).captureStream?.();
  for (const track of voice?.getAudioTracks() ?? []) {
    stream.addTrack(track);
  }
  const recorder = new MediaRecorder(stream, { mimeType: "video/webm", videoBitsPerSecond: 8_000_000 });
  /** @type {Blob[]} */
  const pieces = [];
  recorder.addEventListener("dataavailable", ({ data }) => pieces.push(data));
  const stopped = new Promise((resolve) => recorder.addEventListener("stop", resolve, { once: true }));
  store.set(TIME_S, 0);
  store.set(PLAYBACK, { playing: true, speed: 1, loop: null });
  recorder.start();
  await playedToTheEnd(store, length_s, tell);
  recorder.stop();
  await stopped;
  return new Blob(pieces, { type: "video/webm" });
}
