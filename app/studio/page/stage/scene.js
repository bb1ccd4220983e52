/** A place to stand: ground, lights, a camera that the pointer orbits, and the drawing of it all. */

import {
  CircleGeometry,
  Color,
  DirectionalLight,
  HemisphereLight,
  Mesh,
  MeshStandardMaterial,
  PCFShadowMap,
  PerspectiveCamera,
  Scene,
  WebGLRenderer,
} from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";

import { followOrbitKeys } from "./orbit_keys.js";

const GROUND = 0x8a9478;
const LARGEST_PIXEL_RATIO = 2;

/**
 * What is drawn, where, and how it is looked at. `draw()` draws it once; `fit()` takes over the size of the canvas.
 *
 * @typedef {object} Place
 * @property {Scene} scene
 * @property {PerspectiveCamera} camera
 * @property {OrbitControls} controls
 * @property {WebGLRenderer} renderer
 * @property {() => void} draw
 * @property {() => boolean} fit whether the size was another one
 */

/**
 * @param {HTMLCanvasElement} canvas
 * @returns {Place}
 */
export function makePlace(canvas) {
  const renderer = new WebGLRenderer({ canvas, antialias: true, preserveDrawingBuffer: true });
  renderer.setPixelRatio(Math.min(devicePixelRatio, LARGEST_PIXEL_RATIO));
  renderer.shadowMap.enabled = true;
  renderer.shadowMap.type = PCFShadowMap;
  const scene = new Scene();
  scene.background = new Color(0xc9d3d8);
  scene.add(new HemisphereLight(0xffffff, GROUND, 1.6), sun(), ground());
  const camera = new PerspectiveCamera(32, 1, 0.05, 50);
  const controls = new OrbitControls(camera, canvas);
  followOrbitKeys(canvas, controls);
  const fit = () => fitted(renderer, camera, canvas);
  return { scene, camera, controls, renderer, fit, draw: () => renderer.render(scene, camera) };
}

/**
 * @param {WebGLRenderer} renderer
 * @param {PerspectiveCamera} camera
 * @param {HTMLCanvasElement} canvas
 */
function fitted(renderer, camera, canvas) {
  const { clientWidth, clientHeight } = canvas;
  const ratio = renderer.getPixelRatio();
  const isSame = canvas.width === Math.floor(clientWidth * ratio) && canvas.height === Math.floor(clientHeight * ratio);
  if (isSame || clientWidth === 0 || clientHeight === 0) {
    return false;
  }
  renderer.setSize(clientWidth, clientHeight, false);
  camera.aspect = clientWidth / clientHeight;
  camera.updateProjectionMatrix();
  return true;
}

function sun() {
  const light = new DirectionalLight(0xfff2dd, 2.2);
  light.position.set(2, 4, 3);
  light.castShadow = true;
  light.shadow.camera.top = light.shadow.camera.right = 2.5;
  light.shadow.camera.bottom = light.shadow.camera.left = -2.5;
  return light;
}

function ground() {
  const disc = new Mesh(new CircleGeometry(12, 48), new MeshStandardMaterial({ color: GROUND, roughness: 1 }));
  disc.rotation.x = -Math.PI / 2;
  disc.receiveShadow = true;
  return disc;
}
