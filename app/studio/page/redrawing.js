/**
 * Forms are drawn anew when what they show changes. Whoever uses the keyboard stays where he was, and what the pointer
 * has pressed stays until it is let go: a field that is left by a click elsewhere changes before that click counts.
 */

/** @type {Map<HTMLElement, readonly Node[]>} */
const waiting = new Map();
/** @type {EventTarget | null} */
let pressed = null;

/** Begins to know what the pointer presses. */
export function watchPointer() {
  document.addEventListener("pointerdown", ({ target }) => (pressed = target), { capture: true });
  for (const end of ["pointerup", "pointercancel"]) {
    document.addEventListener(end, () => setTimeout(release), { capture: true });
  }
}

/**
 * Puts other children into an element. What has the focus has it again if there is still something of its id or label.
 *
 * @param {HTMLElement} element
 * @param {readonly Node[]} children
 */
export function redraw(element, children) {
  if (pressed instanceof Node && element.contains(pressed) && element.childElementCount > 0) {
    waiting.set(element, children);
    return;
  }
  waiting.delete(element);
  const focused = document.activeElement;
  const before = focused && element.contains(focused) ? nameOf(focused) : null;
  element.replaceChildren(...children);
  if (before) {
    const same = [...element.querySelectorAll("button, input, select")].find((each) => nameOf(each) === before);
    /** @type {HTMLElement | undefined} */ (same)?.focus();
  }
}

function release() {
  pressed = null;
  for (const [element, children] of [...waiting]) {
    redraw(element, children);
  }
}

/** @param {Element} element */
function nameOf(element) {
  return element.id || element.getAttribute("aria-label") || element.closest("label")?.textContent || element.textContent;
}
