import assert from "node:assert/strict";
import { test } from "node:test";
import { BufferAttribute, Mesh, MeshBasicMaterial, Object3D, SkinnedMesh, SphereGeometry, Vector3 } from "three";

import { coarseTriangles, drawCoarsely } from "../../../app/studio/page/stage/coarse.js";

const RADIUS = 2;

/**
 * A ball of 2,048 triangles whose halves hang on two joints.
 */
function ball() {
  const geometry = new SphereGeometry(RADIUS, 32, 32).deleteAttribute("uv");
  const { count } = geometry.getAttribute("position");
  const joints = new Uint16Array(4 * count);
  const weights = new Float32Array(4 * count);
  for (let vertex = 0; vertex < count; vertex += 1) {
    joints[4 * vertex] = geometry.getAttribute("position").getX(vertex) < 0 ? 3 : 7;
    weights[4 * vertex] = 1;
  }
  geometry.setAttribute("skinIndex", new BufferAttribute(joints, 4));
  geometry.setAttribute("skinWeight", new BufferAttribute(weights, 4));
  return geometry;
}

test("a coarser surface has a quarter of the triangles, nearly the same volume and faces outwards", () => {
  const geometry = ball();
  const corners = coarseTriangles(geometry);
  assert.ok(corners.length < (geometry.index?.count ?? 0) / 3);
  const position = geometry.getAttribute("position");
  const at = (/** @type {number} */ corner) => new Vector3().fromBufferAttribute(position, corners[corner] ?? 0);
  let volume = 0;
  for (let corner = 0; corner < corners.length; corner += 3) {
    volume += at(corner).dot(at(corner + 1).cross(at(corner + 2))) / 6;
  }
  const whole = (4 / 3) * Math.PI * RADIUS ** 3;
  assert.ok(volume > 0.9 * whole && volume < whole, String(volume / whole));
});

test("what hangs on two joints stays apart along their border, and small surfaces stay as they are", () => {
  const geometry = ball();
  const used = new Set(coarseTriangles(geometry).map((vertex) => geometry.getAttribute("skinIndex").getX(vertex)));
  assert.deepEqual([...used].sort(), [3, 7]);
});

test("surfaces are drawn coarsely and as they are again; those without a skin, small ones and textured ones never change", () => {
  const root = new Object3D();
  const [skinned, still, textured] = [ball(), ball(), ball().setAttribute("uv", new BufferAttribute(new Float32Array(2), 2))];
  const material = new MeshBasicMaterial();
  root.add(new SkinnedMesh(skinned, material), new Mesh(still, material), new SkinnedMesh(textured, material));
  const fine = [skinned, still, textured].map(({ index }) => index);
  drawCoarsely(root, true);
  assert.notEqual(skinned.index, fine[0]);
  assert.deepEqual([still.index, textured.index], fine.slice(1));
  drawCoarsely(root, false);
  assert.deepEqual([skinned.index, still.index, textured.index], fine);
});
