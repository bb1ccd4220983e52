/** Records a line from the microphone: a button that starts and stops, and a WAV file of what was said. */

import { el } from "../dom.js";
import { icon } from "../icons.js";
import { wavOf } from "./wav.js";

const RATE_HZ = 48_000;

/**
 * @param {(recording: File) => void} recorded
 * @param {(error: unknown) => void} failed is told where there is no microphone, or it may not be used
 */
export function microphone(recorded, failed) {
  /** @type {MediaRecorder | null} */
  let recorder = null;
  const button = el("button", { type: "button", id: "record" });
  const show = () => {
    button.replaceChildren(icon("microphone"), recorder ? "Stop and use it" : "Record");
    button.classList.toggle("wrong", recorder !== null);
  };
  show();
  const begin = async () => {
    recorder = await recording((spoken) => void fileOf(spoken).then(recorded, failed));
    show();
  };
  button.addEventListener("click", () => {
    if (recorder) {
      recorder.stop();
      recorder = null;
      show();
    } else {
      begin().catch(failed);
    }
  });
  return button;
}

/**
 * A recorder that records; the microphone is let go when it is stopped.
 *
 * @param {(spoken: Blob) => void} stopped
 */
async function recording(stopped) {
  const stream = await navigator.mediaDevices.getUserMedia({ audio: true });
  const recorder = new MediaRecorder(stream);
  recorder.addEventListener("dataavailable", ({ data }) => {
    stream.getTracks().forEach((track) => track.stop());
    stopped(data);
  });
  recorder.start();
  return recorder;
}

/** @param {Blob} spoken as the browser records it, which not every service decodes */
async function fileOf(spoken) {
  const decoded = await new OfflineAudioContext(1, 1, RATE_HZ).decodeAudioData(await spoken.arrayBuffer());
  const time = new Date().toTimeString().slice(0, 8).replaceAll(":", "-");
  return new File([wavOf(decoded.getChannelData(0), RATE_HZ)], `recording ${time}.wav`, { type: "audio/wav" });
}
