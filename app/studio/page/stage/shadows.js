/**
 * The light that shapes bodies, and their shadows on the floor. The floor is the room's own colour: nothing of it is seen
 * but shadows, so that neither is drawn where the camera sees none.
 */

import { DirectionalLight, Frustum, Group, Matrix4, Mesh, PlaneGeometry, ShadowMaterial, Vector3 } from "three";

/** @import { Camera, Object3D } from "three" */

/** From where the light comes. */
const LIGHT_M = Object.freeze(new Vector3(1.6, 4, 2.8));
/** How far round the middle of the floor shadows are drawn. */
const REACH_M = 2.5;
const FLOOR_M = 9;
/** Heights of which the shadows are looked for. */
const HEIGHTS_M = Object.freeze([0, 0.4, 0.8, 1.2, 1.65]);

export class Shadows {
  /** For the scene. */
  group = new Group();
  #floor = floor();

  constructor() {
    this.group.add(key(), this.#floor);
  }

  /**
   * Whether shadows of what stands in the scene are seen; the floor is there only then.
   *
   * @param {Object3D} scene
   * @param {Camera} camera
   */
  areSeen(scene, camera) {
    const seen = new Frustum().setFromProjectionMatrix(new Matrix4().multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse));
    this.#floor.visible = scene.children.some((each) => castsShadow(each) && shadowOf(each.position).some((place) => seen.containsPoint(place)));
    return this.#floor.visible;
  }
}

/** @param {Object3D} standing */
function castsShadow(standing) {
  let found = false;
  standing.traverse((object) => (found ||= object instanceof Mesh && object.castShadow));
  return found;
}

/**
 * Where the shadow of a body is that stands there.
 *
 * @param {Vector3} place_m
 */
function shadowOf(place_m) {
  return HEIGHTS_M.map((height_m) => LIGHT_M.clone().multiplyScalar(-height_m / LIGHT_M.y).setY(0).add(place_m));
}

function key() {
  const light = new DirectionalLight(0xfff4e6, 2);
  light.position.copy(LIGHT_M);
  light.castShadow = true;
  light.shadow.camera.top = light.shadow.camera.right = REACH_M;
  light.shadow.camera.bottom = light.shadow.camera.left = -REACH_M;
  light.shadow.mapSize.set(1024, 1024);
  light.shadow.radius = 6;
  light.shadow.normalBias = 0.02;
  return light;
}

function floor() {
  const plane = new Mesh(new PlaneGeometry(FLOOR_M, FLOOR_M), new ShadowMaterial({ opacity: 0.28 }));
  plane.rotation.x = -Math.PI / 2;
  plane.position.y = 0.001;
  plane.receiveShadow = true;
  return plane;
}
