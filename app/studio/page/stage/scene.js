/** A place to stand: a neutral studio with soft light, and a camera that the pointer orbits. */

import { Color, DirectionalLight, Fog, GridHelper, HemisphereLight, PerspectiveCamera, Scene } from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";

import { FIELD_DEG } from "./framing.js";
import { followOrbitKeys } from "./orbit_keys.js";
import { Picturing } from "./picturing.js";
import { Shadows } from "./shadows.js";

/** @import { Store } from "../state/store.js" */
/** @import { Size } from "./picturing.js" */

const FLOOR_M = 24;
const [FOG_FROM_M, FOG_TO_M] = [4, 13];

/** The colours of the room where nobody says others. */
const NEUTRAL = Object.freeze({ stage: "#d7dce0", grid: "#b3bac0" });

/**
 * What is drawn, where, and how it is looked at. `draw()` draws it once, as finely as is quick, `picture()` finely;
 * `fit()`, which is called before each frame, takes over the size of the canvas, or the one that is given to `fix`;
 * `paint` gives the room colours.
 *
 * @typedef {object} Place
 * @property {Scene} scene
 * @property {PerspectiveCamera} camera
 * @property {OrbitControls} controls
 * @property {() => void} draw
 * @property {() => void} picture
 * @property {() => boolean} fit whether the size was another one
 * @property {(size: Size | null) => void} fix
 * @property {(colours: Readonly<{ stage: string, grid: string }>) => void} paint
 */

/**
 * @param {HTMLCanvasElement} canvas
 * @param {Store} store
 * @returns {Place}
 */
export function makePlace(canvas, store) {
  const scene = new Scene();
  const grid = new GridHelper(FLOOR_M, 2 * FLOOR_M);
  const shadows = new Shadows();
  scene.add(new HemisphereLight(0xffffff, 0xb9b2aa, 1.5), shadows.group, rim(), grid);
  const camera = new PerspectiveCamera(FIELD_DEG, 1, 0.05, 50);
  const controls = new OrbitControls(camera, canvas);
  followOrbitKeys(canvas, controls);
  const picturing = new Picturing(canvas, { scene, camera, shadows }, store);
  const paint = (/** @type {Readonly<{ stage: string, grid: string }>} */ colours) => {
    scene.background = new Color(colours.stage);
    scene.fog = new Fog(colours.stage, FOG_FROM_M, FOG_TO_M);
    grid.material.color.set(colours.grid);
  };
  grid.material.vertexColors = false;
  paint(NEUTRAL);
  return {
    scene,
    camera,
    controls,
    paint,
    draw: () => picturing.draw(),
    picture: () => picturing.picture(),
    fit: () => picturing.fit(),
    fix: (size) => picturing.fix(size),
  };
}

/** The light from behind that parts the body from the room. */
function rim() {
  const light = new DirectionalLight(0xdce8ff, 1.1);
  light.position.set(-2.2, 2.6, -3);
  return light;
}
