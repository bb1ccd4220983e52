/**
 * A place to stand: a neutral studio with soft light, a camera that the pointer orbits, and the drawing of it all. Where the
 * browser has no WebGL, nothing is drawn but a note that says so, and all else goes on.
 */

import {
  Color,
  DirectionalLight,
  Fog,
  GridHelper,
  HemisphereLight,
  Mesh,
  PCFShadowMap,
  PerspectiveCamera,
  PlaneGeometry,
  Scene,
  ShadowMaterial,
  WebGLRenderer,
} from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";

import { el } from "../dom.js";
import { FIELD_DEG } from "./framing.js";
import { followOrbitKeys } from "./orbit_keys.js";

const LARGEST_PIXEL_RATIO = 2;
const FLOOR_M = 24;
const [FOG_FROM_M, FOG_TO_M] = [4, 13];

const NO_PICTURE = "This browser draws no bodies: WebGL is missing or switched off. The line is performed, played, changed and exported all the same.";

/** The colours of the room where nobody says others. */
const NEUTRAL = Object.freeze({ stage: "#d7dce0", grid: "#b3bac0" });

/**
 * What is drawn, where, and how it is looked at. `draw()` draws it once; `fit()` takes over the size of the canvas, or
 * the one that is given to `fix`; `paint` gives the room colours.
 *
 * @typedef {object} Place
 * @property {Scene} scene
 * @property {PerspectiveCamera} camera
 * @property {OrbitControls} controls
 * @property {() => void} draw
 * @property {() => boolean} fit whether the size was another one
 * @property {(size: Size | null) => void} fix
 * @property {(colours: Readonly<{ stage: string, grid: string }>) => void} paint
 */

/** @typedef {Readonly<{ width_px: number, height_px: number }>} Size */

/**
 * @param {HTMLCanvasElement} canvas
 * @returns {Place}
 */
export function makePlace(canvas) {
  const renderer = rendererOn(canvas);
  const scene = new Scene();
  const grid = new GridHelper(FLOOR_M, 2 * FLOOR_M);
  scene.add(new HemisphereLight(0xffffff, 0xb9b2aa, 1.5), key(), rim(), ground(), grid);
  const camera = new PerspectiveCamera(FIELD_DEG, 1, 0.05, 50);
  const controls = new OrbitControls(camera, canvas);
  followOrbitKeys(canvas, controls);
  const fixed = /** @type {{ size: Size | null }} */ ({ size: null });
  const paint = (/** @type {Readonly<{ stage: string, grid: string }>} */ colours) => {
    scene.background = new Color(colours.stage);
    scene.fog = new Fog(colours.stage, FOG_FROM_M, FOG_TO_M);
    grid.material.color.set(colours.grid);
  };
  grid.material.vertexColors = false;
  paint(NEUTRAL);
  const fit = () => fitted(renderer, camera, canvas, fixed.size);
  const fix = (/** @type {Size | null} */ size) => void (fixed.size = size);
  return { scene, camera, controls, fit, fix, paint, draw: () => renderer?.render(scene, camera) };
}

/**
 * Null where the browser has no WebGL.
 *
 * @param {HTMLCanvasElement} canvas
 */
function rendererOn(canvas) {
  try {
    const renderer = new WebGLRenderer({ canvas, antialias: true, preserveDrawingBuffer: true });
    renderer.shadowMap.enabled = true;
    renderer.shadowMap.type = PCFShadowMap;
    return renderer;
  } catch {
    queueMicrotask(() => canvas.after(el("p", { class: "no-picture", role: "status" }, [NO_PICTURE])));
    return null;
  }
}

/**
 * @param {WebGLRenderer | null} renderer
 * @param {PerspectiveCamera} camera
 * @param {HTMLCanvasElement} canvas
 * @param {Size | null} fixed
 */
function fitted(renderer, camera, canvas, fixed) {
  const ratio = fixed ? 1 : Math.min(devicePixelRatio, LARGEST_PIXEL_RATIO);
  const { width_px, height_px } = fixed ?? { width_px: canvas.clientWidth, height_px: canvas.clientHeight };
  const isSame = canvas.width === Math.floor(width_px * ratio) && canvas.height === Math.floor(height_px * ratio);
  if (!renderer || isSame || width_px === 0 || height_px === 0) {
    return false;
  }
  renderer.setPixelRatio(ratio);
  renderer.setSize(width_px, height_px, false);
  camera.aspect = width_px / height_px;
  camera.updateProjectionMatrix();
  return true;
}

/** The light that shapes the body, from before it and above. */
function key() {
  const light = new DirectionalLight(0xfff4e6, 2);
  light.position.set(1.6, 4, 2.8);
  light.castShadow = true;
  light.shadow.camera.top = light.shadow.camera.right = 2.5;
  light.shadow.camera.bottom = light.shadow.camera.left = -2.5;
  light.shadow.mapSize.set(1024, 1024);
  light.shadow.radius = 6;
  light.shadow.normalBias = 0.02;
  return light;
}

/** The light from behind that parts the body from the room. */
function rim() {
  const light = new DirectionalLight(0xdce8ff, 1.1);
  light.position.set(-2.2, 2.6, -3);
  return light;
}

/** The floor is the room's own colour: nothing of it is seen but shadows. */
function ground() {
  const floor = new Mesh(new PlaneGeometry(FLOOR_M, FLOOR_M), new ShadowMaterial({ opacity: 0.28 }));
  floor.rotation.x = -Math.PI / 2;
  floor.position.y = 0.001;
  floor.receiveShadow = true;
  return floor;
}
