/** The place: ground, light, camera, and the drawing of it all. */

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

const SKY = 0xc9d3d8;
const GROUND = 0x8a9478;
const EYES_M = 1.45;

/**
 * A stage that fills the window. `draw` is called before each frame.
 *
 * @param {HTMLCanvasElement} canvas
 * @param {[number, number, number]} cameraPlace
 * @param {() => void} draw
 */
export function makeStage(canvas, [x, , z], draw) {
  const renderer = new WebGLRenderer({ canvas, antialias: true });
  renderer.shadowMap.enabled = true;
  renderer.shadowMap.type = PCFShadowMap;
  const scene = new Scene();
  scene.background = new Color(SKY);
  scene.add(new HemisphereLight(0xffffff, GROUND, 1.6), sun(), ground());
  const camera = new PerspectiveCamera(38, 1, 0.1, 30);
  camera.position.set(x, EYES_M, z);
  camera.lookAt(0.05, 1.12, 0);
  const fit = () => {
    renderer.setSize(innerWidth, innerHeight, false);
    camera.aspect = innerWidth / innerHeight;
    camera.updateProjectionMatrix();
  };
  addEventListener("resize", fit);
  fit();
  renderer.setAnimationLoop(() => {
    draw();
    renderer.render(scene, camera);
  });
  return scene;
}

function sun() {
  const light = new DirectionalLight(0xfff2dd, 2.2);
  light.position.set(2, 4, 3);
  light.castShadow = true;
  light.shadow.camera.top = light.shadow.camera.right = 2;
  light.shadow.camera.bottom = light.shadow.camera.left = -2;
  return light;
}

function ground() {
  const disc = new Mesh(new CircleGeometry(12, 48), new MeshStandardMaterial({ color: GROUND, roughness: 1 }));
  disc.rotation.x = -Math.PI / 2;
  disc.receiveShadow = true;
  return disc;
}
