/** The camera by the keyboard, while its canvas has the focus: W, A, S and D orbit, + and − go nearer and away. */

/** @import { OrbitControls } from "three/addons/controls/OrbitControls.js" */

const STEP_RAD = Math.PI / 24;
const NEARER = 0.9;

/** @type {Readonly<Record<string, (controls: OrbitControls) => void>>} */
const KEYS = Object.freeze({
  a: (controls) => controls.rotateLeft(STEP_RAD),
  d: (controls) => controls.rotateLeft(-STEP_RAD),
  w: (controls) => controls.rotateUp(STEP_RAD),
  s: (controls) => controls.rotateUp(-STEP_RAD),
  "+": (controls) => controls.dollyIn(NEARER),
  "=": (controls) => controls.dollyIn(NEARER),
  "-": (controls) => controls.dollyOut(NEARER),
});

/**
 * @param {HTMLCanvasElement} canvas
 * @param {OrbitControls} controls
 */
export function followOrbitKeys(canvas, controls) {
  canvas.addEventListener("keydown", ({ key, ctrlKey, metaKey, altKey }) => {
    if (!ctrlKey && !metaKey && !altKey) {
      KEYS[key.toLowerCase()]?.(controls);
    }
  });
}
