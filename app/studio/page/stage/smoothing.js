/** Smooth edges on a canvas that has none of its own. */

import { Mesh, OrthographicCamera, PlaneGeometry, Scene, ShaderMaterial, SRGBColorSpace, Vector2, WebGLRenderTarget } from "three";

/** @import { Camera, WebGLRenderer } from "three" */

const SAMPLES = 4;
const VERTEX = "varying vec2 at; void main() { at = uv; gl_Position = vec4(position.xy, 0.0, 1.0); }";
const FRAGMENT = "uniform sampler2D picture; varying vec2 at; void main() { gl_FragColor = texture2D(picture, at); }";

export class Smoothing {
  #renderer;
  #target;
  #sheet = new Scene();
  #camera = new OrthographicCamera();
  #size = new Vector2();

  /** @param {WebGLRenderer} renderer */
  constructor(renderer) {
    this.#renderer = renderer;
    this.#target = new WebGLRenderTarget(1, 1, { samples: SAMPLES, colorSpace: SRGBColorSpace, internalFormat: "RGBA8" });
    // So marked, colours are mixed and kept as on the canvas.
    Object.assign(this.#target, { isXRRenderTarget: true });
    const uniforms = { picture: { value: this.#target.texture } };
    const shown = new Mesh(new PlaneGeometry(2, 2), new ShaderMaterial({ uniforms, vertexShader: VERTEX, fragmentShader: FRAGMENT, depthTest: false }));
    shown.frustumCulled = false;
    this.#sheet.add(shown);
  }

  /**
   * @param {Scene} scene
   * @param {Camera} camera
   */
  render(scene, camera) {
    const { x, y } = this.#renderer.getDrawingBufferSize(this.#size);
    this.#target.setSize(x, y);
    this.#renderer.setRenderTarget(this.#target);
    this.#renderer.render(scene, camera);
    this.#renderer.setRenderTarget(null);
    this.#renderer.render(this.#sheet, this.#camera);
  }
}
