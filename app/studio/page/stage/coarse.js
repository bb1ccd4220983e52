/**
 * A coarser surface over the same vertices: those of a small part of the surface become the one in its middle. Only the
 * triangles are others, so skin, weights and the shapes of the face stay as they are.
 */

import { BufferAttribute, SkinnedMesh } from "three";

/** @import { BufferGeometry, InterleavedBufferAttribute, Object3D } from "three" */

/** @typedef {BufferAttribute | InterleavedBufferAttribute} Attribute */

/** How large a part is, in edges of the triangles around its joint: hands stay finer than the trunk, faces than both. */
const [PART_EDGES, PART_OF_FACE_EDGES] = [2.2, 1.35];
/** Eyes, lips and teeth have fewer corners than this, and stay as they are. */
const FEWEST_CORNERS = 1800;
const [CELLS, JOINTS] = [2048, 256];

/** The triangles of surfaces that can be coarser. @type {WeakMap<BufferGeometry, Readonly<{ fine: BufferAttribute, coarse: BufferAttribute }>>} */
const surfaces = new WeakMap();

/**
 * Draws every skinned surface below an object coarsely, or as it is. Those with textures always stay as they are.
 *
 * @param {Object3D} root
 * @param {boolean} isCoarse
 */
export function drawCoarsely(root, isCoarse) {
  root.traverse((object) => {
    if (object instanceof SkinnedMesh && (isCoarse || surfaces.has(object.geometry))) {
      const found = surfaces.get(object.geometry) ?? surfaceOf(object.geometry);
      if (found) {
        surfaces.set(object.geometry, found);
        object.geometry.setIndex(isCoarse ? found.coarse : found.fine);
      }
    }
  });
}

/** @param {BufferGeometry} geometry */
function surfaceOf(geometry) {
  const fine = geometry.index;
  if (!fine || fine.count < FEWEST_CORNERS || geometry.getAttribute("uv")) {
    return null;
  }
  return { fine, coarse: new BufferAttribute(new Uint32Array(coarseTriangles(geometry)), 1) };
}

/**
 * The corners of the coarser surface's triangles, three vertices each; of a surface without skin there are none. A part
 * is of one joint, so that fingers do not grow together.
 *
 * @param {BufferGeometry} geometry
 * @returns {number[]}
 */
export function coarseTriangles({ index, attributes, morphAttributes }) {
  const { position, skinIndex, skinWeight } = attributes;
  if (!index || !position || !skinIndex || !skinWeight) {
    return [];
  }
  const vertices = Array.from({ length: position.count }, (_, vertex) => vertex);
  const joints = vertices.map((vertex) => jointOf(skinIndex, skinWeight, vertex));
  const edges_m = meanEdges(index, position, joints);
  const part_edges = morphAttributes.position ? PART_OF_FACE_EDGES : PART_EDGES;
  const parts = vertices.map((vertex) => {
    const joint = joints[vertex] ?? 0;
    const part_m = part_edges * (edges_m[joint] ?? 0);
    return partOf(placeOf(position, vertex).map((metres) => Math.floor(metres / part_m)), joint);
  });
  return joined(index, middles(parts, position));
}

/**
 * @param {readonly number[]} cell
 * @param {number} joint
 */
function partOf(cell, joint) {
  return cell.reduce((sum, place) => sum * CELLS + place + CELLS / 2, 0) * JOINTS + joint;
}

/**
 * @param {Attribute} of
 * @param {number} vertex
 * @returns {[number, number, number]}
 */
function placeOf(of, vertex) {
  return [of.getX(vertex), of.getY(vertex), of.getZ(vertex)];
}

/**
 * The joint on which a vertex hangs most.
 *
 * @param {Attribute} joints
 * @param {Attribute} weights
 * @param {number} vertex
 */
function jointOf(joints, weights, vertex) {
  let most = 0;
  for (const other of [1, 2, 3]) {
    most = weights.getComponent(vertex, other) > weights.getComponent(vertex, most) ? other : most;
  }
  return joints.getComponent(vertex, most);
}

/**
 * The mean length of edges by the joint of a vertex that they lead to, metres.
 *
 * @param {BufferAttribute} index
 * @param {Attribute} position
 * @param {readonly number[]} joints
 */
function meanEdges(index, position, joints) {
  const sums = new Float64Array(JOINTS);
  const counts = new Float64Array(JOINTS);
  for (let corner = 0; corner < index.count; corner += 1) {
    const before = corner % 3 === 0 ? corner + 2 : corner - 1;
    const [[x, y, z], [fromX, fromY, fromZ]] = [placeOf(position, index.getX(corner)), placeOf(position, index.getX(before))];
    const joint = joints[index.getX(corner)] ?? 0;
    sums[joint] = (sums[joint] ?? 0) + Math.hypot(x - fromX, y - fromY, z - fromZ);
    counts[joint] = (counts[joint] ?? 0) + 1;
  }
  return sums.map((sum, joint) => sum / (counts[joint] ?? 1));
}

/**
 * For every vertex the one of its part that is nearest to the part's middle.
 *
 * @param {readonly number[]} parts
 * @param {Attribute} position
 */
function middles(parts, position) {
  /** @type {Map<number, number[]>} */
  const members = new Map();
  parts.forEach((part, vertex) => {
    const found = members.get(part) ?? [];
    found.push(vertex);
    members.set(part, found);
  });
  const middle = new Uint32Array(parts.length);
  for (const vertices of members.values()) {
    const nearest = nearestToMean(vertices, position);
    vertices.forEach((vertex) => (middle[vertex] = nearest));
  }
  return middle;
}

/**
 * @param {readonly number[]} vertices
 * @param {Attribute} position
 */
function nearestToMean(vertices, position) {
  const places = vertices.map((vertex) => placeOf(position, vertex));
  const mean = [0, 1, 2].map((axis) => places.reduce((sum, place) => sum + (place[axis] ?? 0), 0) / places.length);
  const ways = places.map((place) => Math.hypot(...place.map((metres, axis) => metres - (mean[axis] ?? 0))));
  return vertices[ways.indexOf(Math.min(...ways))] ?? 0;
}

/**
 * The triangles whose corners are still three.
 *
 * @param {BufferAttribute} index
 * @param {Uint32Array} middle
 */
function joined(index, middle) {
  const corners = [];
  for (let corner = 0; corner < index.count; corner += 3) {
    const [one = 0, two = 0, three = 0] = [0, 1, 2].map((place) => middle[index.getX(corner + place)]);
    if (one !== two && two !== three && three !== one) {
      corners.push(one, two, three);
    }
  }
  return corners;
}
