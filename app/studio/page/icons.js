/** The page's icons: strokes on a square of 16 × 16 in the colour of the text around them. */

const NAMESPACE = "http://www.w3.org/2000/svg";

/** Paths by name; those of FILLED are surfaces. */
const PATHS = Object.freeze({
  play: "M4.5 2.5v11l9-5.5z",
  pause: "M4 3h3v10H4zM9 3h3v10H9z",
  step_back: "M12 3.5v9L6 8zM4 3.5h1.4v9H4z",
  step_on: "M4 3.5v9L10 8zM10.6 3.5H12v9h-1.4z",
  loop: "M3 7V6.2A2.7 2.7 0 0 1 5.7 3.5H12M10 1.5l2 2-2 2M13 9v.8a2.7 2.7 0 0 1-2.7 2.7H4M6 10.5l-2 2 2 2",
  undo: "M6 3 2.5 6.5 6 10M2.5 6.5h7a3.5 3.5 0 0 1 0 7H6",
  redo: "M10 3l3.5 3.5L10 10M13.5 6.5h-7a3.5 3.5 0 0 0 0 7H10",
  zoom_in: "M11 7a4 4 0 1 1-8 0 4 4 0 0 1 8 0M10 10l3.5 3.5M7 5.2v3.6M5.2 7h3.6",
  zoom_out: "M11 7a4 4 0 1 1-8 0 4 4 0 0 1 8 0M10 10l3.5 3.5M5.2 7h3.6",
  whole: "M2.5 3v10M13.5 3v10M4.8 8h6.4M6.6 6l-2 2 2 2M9.4 6l2 2-2 2",
  selection: "M2.5 5.5v-3h3M10.5 2.5h3v3M13.5 10.5v3h-3M5.5 13.5h-3v-3M6 6h4v4H6z",
  earlier: "M10 3.5 5.5 8l4.5 4.5",
  later: "M6 3.5 10.5 8 6 12.5",
  ripple: "M2 8h6M5.8 5.8 8 8l-2.2 2.2M10 4v8M12 4v8M14 4v8",
  list: "M5.5 4h8M5.5 8h8M5.5 12h8M2.5 4h.5M2.5 8h.5M2.5 12h.5",
  alternatives: "M2.5 4.5h11v3h-11zM2.5 10h2M6 10h2M9.5 10h2M2.5 12.5h2M6 12.5h2M9.5 12.5h2",
  lock: "M4 7.5h8v6H4zM5.5 7.5v-2a2.5 2.5 0 0 1 5 0v2",
  mute: "M2 8s2.2-4 6-4 6 4 6 4-2.2 4-6 4-6-4-6-4zM3 13.5l10-11",
  trash: "M3 4.5h10M6 4.5V3h4v1.5M4.5 4.5l.6 8.5h5.8l.6-8.5",
  reset: "M3.5 6.5A5 5 0 1 1 3 9M3 3.5v3.2h3.2",
  microphone: "M8 2a2 2 0 0 1 2 2v3.2a2 2 0 0 1-4 0V4a2 2 0 0 1 2-2zM3.8 7.5a4.2 4.2 0 0 0 8.4 0M8 11.8V14",
  history: "M8 2.5a5.5 5.5 0 1 1-.02 0M8 5v3.2l2.2 1.3",
  theme: "M8 2.2a5.8 5.8 0 1 0 .02 0zM8 2.2v11.6a5.8 5.8 0 0 0 0-11.6z",
  text: "M3 4h10M3 7h10M3 10h6",
  file: "M4 2.5h5l3 3v8H4zM9 2.5v3h3",
  add: "M8 3v10M3 8h10",
  star: "M8 2.2l1.8 3.7 4 .6-2.9 2.8.7 4L8 11.4l-3.6 1.9.7-4L2.2 6.5l4-.6z",
});
const FILLED = new Set(["play", "pause", "step_back", "step_on"]);

/** @typedef {keyof typeof PATHS} IconName */

/**
 * A picture for those who see it; whatever it stands in needs a name of its own.
 *
 * @param {IconName} name
 */
export function icon(name) {
  const made = document.createElementNS(NAMESPACE, "svg");
  const path = document.createElementNS(NAMESPACE, "path");
  path.setAttribute("d", PATHS[name]);
  for (const [key, value] of Object.entries({ class: FILLED.has(name) ? "icon filled" : "icon", viewBox: "0 0 16 16", "aria-hidden": "true" })) {
    made.setAttribute(key, value);
  }
  made.append(path);
  return made;
}
