/**
 * Draws a scene on a canvas, as finely as is wanted and quick enough (detail.js): a pixel's edges, the surfaces of bodies.
 * Where the browser has no WebGL, nothing is drawn but a note that says so, and all else goes on.
 */

import { PCFShadowMap, WebGLRenderer } from "three";

import { el } from "../dom.js";
import { drawCoarsely } from "./coarse.js";
import { Pace, QUALITY } from "./detail.js";
import { Smoothing } from "./smoothing.js";

/** @import { PerspectiveCamera, Scene } from "three" */
/** @import { Store } from "../state/store.js" */
/** @import { Shadows } from "./shadows.js" */

/** @typedef {Readonly<{ width_px: number, height_px: number }>} Size */
/** What is drawn, and from where. @typedef {Readonly<{ scene: Scene, camera: PerspectiveCamera, shadows: Shadows }>} View */

const LARGEST_PIXEL_RATIO = 2;
/** After so long without another picture, what was drawn coarsely is drawn finely. */
const REST_MS = 800;

const NO_PICTURE = "This browser draws no bodies: WebGL is missing or switched off. The line is performed, played, changed and exported all the same.";
/** What draws without a graphics card in browsers on Linux, macOS and Windows. */
const SOFTWARE = /swiftshader|llvmpipe|softpipe|software|basic render/i;

/** The canvas has `data-detail` (`fine` or `coarse`) for tests and benchmarks. */
export class Picturing {
  #canvas;
  #view;
  #store;
  #renderer;
  #smoothing;
  #pace;
  #fixed = /** @type {Size | null} */ (null);
  #turn = 0;
  #drawn = 0;
  #rest = 0;

  /**
   * @param {HTMLCanvasElement} canvas
   * @param {View} view
   * @param {Store} store
   */
  constructor(canvas, view, store) {
    const renderer = rendererOn(canvas);
    this.#canvas = canvas;
    this.#view = view;
    this.#store = store;
    this.#renderer = renderer;
    this.#smoothing = renderer && new Smoothing(renderer);
    this.#pace = new Pace(renderer !== null && isSoftware(renderer));
    store.watch(QUALITY, () => renderer && this.#drawn > 0 && this.draw());
  }

  /** @param {Size | null} size of pictures, which are always fine; null for that of the canvas on the page */
  fix(size) {
    this.#fixed = size;
  }

  /** Takes over the size; call it before each frame. Whether it was another one. */
  fit() {
    this.#turn += 1;
    return fitted(this.#renderer, this.#view.camera, this.#canvas, this.#fixed);
  }

  draw() {
    const quality = this.#store.get(QUALITY);
    if (this.#drawn === this.#turn - 1) {
      this.#pace.frame(performance.now());
    }
    this.#drawn = this.#turn;
    const isCoarse = !this.#fixed && (quality === "low" || (quality === "automatic" && this.#pace.isCoarse));
    this.#render(isCoarse);
    if (isCoarse && quality === "automatic") {
      this.#rest = window.setTimeout(() => this.#render(false), REST_MS);
    }
  }

  /** Draws finely. */
  picture() {
    this.#render(false);
  }

  /** @param {boolean} isCoarse */
  #render(isCoarse) {
    clearTimeout(this.#rest);
    const { scene, camera, shadows } = this.#view;
    if (this.#renderer && this.#smoothing) {
      drawCoarsely(scene, isCoarse);
      camera.updateMatrixWorld();
      this.#renderer.shadowMap.autoUpdate = shadows.areSeen(scene, camera);
      (isCoarse ? this.#renderer : this.#smoothing).render(scene, camera);
      this.#canvas.dataset["detail"] = isCoarse ? "coarse" : "fine";
    }
  }
}

/**
 * Null where the browser has no WebGL. Edges are jagged, since smooth ones take twice as long without a graphics card:
 * Smoothing makes them.
 *
 * @param {HTMLCanvasElement} canvas
 */
function rendererOn(canvas) {
  const context = canvas.getContext("webgl2", { antialias: false, preserveDrawingBuffer: true });
  if (!context) {
    queueMicrotask(() => canvas.after(el("p", { class: "no-picture", role: "status" }, [NO_PICTURE])));
    return null;
  }
  const renderer = new WebGLRenderer({ canvas, context });
  renderer.shadowMap.enabled = true;
  renderer.shadowMap.type = PCFShadowMap;
  return renderer;
}

/**
 * Whether the browser says that it draws without a graphics card.
 *
 * @param {WebGLRenderer} renderer
 */
function isSoftware(renderer) {
  const context = renderer.getContext();
  const name = context.getExtension("WEBGL_debug_renderer_info")?.UNMASKED_RENDERER_WEBGL ?? context.RENDERER;
  return SOFTWARE.test(String(context.getParameter(name)));
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
