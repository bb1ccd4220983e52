/** One request at a time, and always for the latest: the service ends the process whose client goes away. */

/**
 * A function that has `work` done once more, now or when it is done, however often it is called meanwhile. `work` gets
 * to know whether it is still the latest.
 *
 * @param {(isLatest: () => boolean) => Promise<void>} work
 * @returns {() => Promise<void>}
 */
export function latest(work) {
  let isAsked = false;
  let isRunning = false;
  return async () => {
    isAsked = true;
    if (isRunning) {
      return;
    }
    isRunning = true;
    while (isAsked) {
      isAsked = false;
      await work(() => !isAsked);
    }
    isRunning = false;
  };
}
