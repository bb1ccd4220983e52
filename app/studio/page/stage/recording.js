/** The recording of the line, as something that sounds. */

import { el } from "../dom.js";
import { TIME_S } from "../state/performed.js";
import { isRecorded, PROJECT } from "../state/project.js";

/** @import { Store } from "../state/store.js" */

/**
 * An element that plays it, whichever it is; with another one the playhead is at the beginning.
 *
 * @param {Store} store
 */
export function recordingOf(store) {
  const audio = el("audio");
  audio.preservesPitch = true;
  /** @type {File | null} */
  let file = null;
  store.watch(PROJECT, (project) => {
    if (project.audio !== file) {
      URL.revokeObjectURL(audio.src);
      file = project.audio;
      if (file && isRecorded(file)) {
        audio.src = URL.createObjectURL(file);
      } else {
        audio.removeAttribute("src");
      }
      store.set(TIME_S, 0);
    }
  });
  return audio;
}
