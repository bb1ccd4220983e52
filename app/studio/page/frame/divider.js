/** The border between stage and timeline, moved by the pointer or by the arrows up and down; where it is, is kept. */

const KEY = "understudy-timeline-percent";
const [LEAST, MOST, STEP] = [20, 65, 4];

/** @param {HTMLElement} element */
export function mountDivider(element) {
  const parent = /** @type {HTMLElement} */ (element.parentElement);
  let percent = Number(localStorage.getItem(KEY) ?? 42);
  const put = (/** @type {number} */ wanted) => {
    percent = Math.min(MOST, Math.max(LEAST, wanted));
    parent.style.setProperty("--timeline", `${String(percent)}%`);
    element.setAttribute("aria-valuenow", String(Math.round(percent)));
    localStorage.setItem(KEY, String(percent));
  };
  element.setAttribute("aria-valuemin", String(LEAST));
  element.setAttribute("aria-valuemax", String(MOST));
  element.addEventListener("pointerdown", ({ pointerId }) => element.setPointerCapture(pointerId));
  element.addEventListener("pointermove", ({ pointerId, clientY }) => {
    if (element.hasPointerCapture(pointerId)) {
      const { bottom, height } = parent.getBoundingClientRect();
      put((100 * (bottom - clientY)) / height);
    }
  });
  element.addEventListener("keydown", (event) => {
    const way = event.key === "ArrowUp" ? 1 : event.key === "ArrowDown" ? -1 : 0;
    if (way !== 0) {
      event.preventDefault();
      put(percent + way * STEP);
    }
  });
  put(percent);
}
