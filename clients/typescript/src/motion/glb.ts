/**
 * Reads a clip from the service's GLB on the built-in mannequin, baked or with sparse keys.
 *
 * Read are its animations alone, not its meshes: whoever wants those loads the file with a glTF loader, which plays
 * files with an avatar of yours, too. Accessors are floats without stride or sparse parts, as the service writes them.
 */

import type { Clip, ClipEvent, Joint, Track } from "./clip.js";
import type { Vector } from "./vectors.js";

interface Gltf {
  readonly nodes: readonly { name: string; translation?: Vector; children?: number[]; mesh?: number }[];
  readonly meshes: readonly { extras?: { targetNames?: string[] } }[];
  readonly skins: readonly { joints: number[] }[];
  readonly animations: readonly Animation[];
  readonly accessors: readonly { bufferView: number; byteOffset?: number; count: number; type: string }[];
  readonly bufferViews: readonly { byteOffset?: number }[];
}

interface Animation {
  readonly channels: readonly { sampler: number; target: { node: number; path: string } }[];
  readonly samplers: readonly { input: number; output: number }[];
  readonly extras: {
    audio_offset_s: number;
    events?: { behavior: string; point: string; time_s: number }[];
    markers?: { id: string; points_s: Record<string, number> }[];
  };
}

interface Glb {
  readonly tree: Gltf;
  readonly content: ArrayBuffer;
  readonly contentStart: number;
}

const MAGIC = 0x46546c67;
const HEADER_BYTES = 12;
const CHUNK_HEADER_BYTES = 8;
const SIZES: Readonly<Record<string, number>> = { SCALAR: 1, VEC3: 3, VEC4: 4 };

/** The clip. Throws a RangeError where the file is not a GLB, or has no animation. */
export function clipFromGlb(file: ArrayBuffer): Clip {
  const glb = opened(file);
  const { animations } = glb.tree;
  const [first] = animations;
  if (!first) {
    throw new RangeError("the GLB has no animation");
  }
  const tracks = tracksOf(glb);
  return {
    durationS: Math.max(...tracks.times),
    audioOffsetS: first.extras.audio_offset_s,
    joints: joints(glb.tree),
    hips: tracks.hips,
    turns: tracks.turns,
    shapes: tracks.shapes,
    visemes: new Map(),
    events: animations.flatMap(events).sort((a, b) => a.timeS - b.timeS),
  };
}

function opened(file: ArrayBuffer): Glb {
  const view = new DataView(file);
  if (file.byteLength < HEADER_BYTES + CHUNK_HEADER_BYTES || view.getUint32(0, true) !== MAGIC) {
    throw new RangeError("this is not a GLB file");
  }
  const jsonStart = HEADER_BYTES + CHUNK_HEADER_BYTES;
  const jsonBytes = view.getUint32(HEADER_BYTES, true);
  const told = JSON.parse(new TextDecoder().decode(new Uint8Array(file, jsonStart, jsonBytes))) as Partial<Gltf>;
  const tree = { nodes: [], meshes: [], skins: [], animations: [], accessors: [], bufferViews: [], ...told };
  return { tree, content: file, contentStart: jsonStart + jsonBytes + CHUNK_HEADER_BYTES };
}

function joints({ nodes, skins }: Gltf): Joint[] {
  const parents = new Map(nodes.flatMap((node) => (node.children ?? []).map((child) => [child, node.name] as const)));
  return (skins[0]?.joints ?? []).map((number) => {
    const { name, translation } = at(nodes, number);
    return { name, parent: parents.get(number) ?? null, offsetM: translation ?? [0, 0, 0] };
  });
}

interface Tracks {
  readonly hips: Track;
  readonly turns: Map<string, Track>;
  readonly shapes: Map<string, Track>;
  readonly times: readonly number[];
}

function tracksOf(glb: Glb): Tracks {
  const found = { turns: new Map<string, Track>(), shapes: new Map<string, Track>(), times: [0] };
  let hips: Track = { timesS: Float32Array.of(0), values: Float32Array.of(0, 0, 0), size: 3 };
  for (const animation of glb.tree.animations) {
    for (const { sampler, target } of animation.channels) {
      const { input, output } = at(animation.samplers, sampler);
      const track = { timesS: floats(glb, input), values: floats(glb, output), size: sizeOf(glb.tree, output) };
      found.times.push(track.timesS.at(-1) ?? 0);
      if (target.path === "rotation") {
        found.turns.set(at(glb.tree.nodes, target.node).name, track);
      } else if (target.path === "translation") {
        hips = track;
      } else {
        addWeights(found.shapes, shapeNames(glb.tree, target.node), track);
      }
    }
  }
  return { ...found, hips };
}

/** Adds a track for each of a mesh's shapes; its weights lie together in each key. */
function addWeights(shapes: Map<string, Track>, names: readonly string[], { timesS, values }: Track): void {
  for (const [shape, name] of names.entries()) {
    if (!name.startsWith("viseme_")) {
      const own = timesS.map((_, key) => values[key * names.length + shape] ?? 0);
      shapes.set(name, { timesS, values: own, size: 1 });
    }
  }
}

function shapeNames({ nodes, meshes }: Gltf, node: number): readonly string[] {
  const { mesh } = at(nodes, node);
  return mesh === undefined ? [] : (meshes[mesh]?.extras?.targetNames ?? []);
}

function events({ extras }: Animation): ClipEvent[] {
  const baked = (extras.events ?? []).map(({ behavior, point, time_s }) => ({ behavior, point, timeS: time_s }));
  const marked = (extras.markers ?? []).flatMap(({ id, points_s }) =>
    Object.entries(points_s).map(([point, timeS]) => ({ behavior: id, point, timeS })),
  );
  return [...baked, ...marked];
}

function floats({ tree, content, contentStart }: Glb, number: number): Float32Array {
  const accessor = at(tree.accessors, number);
  const start = contentStart + (at(tree.bufferViews, accessor.bufferView).byteOffset ?? 0) + (accessor.byteOffset ?? 0);
  const bytes = 4 * accessor.count * sizeOf(tree, number);
  return new Float32Array(content.slice(start, start + bytes));
}

function sizeOf(tree: Gltf, number: number): number {
  return SIZES[at(tree.accessors, number).type] ?? 1;
}

function at<Item>(items: readonly Item[], number: number): Item {
  const item = items[number];
  if (item === undefined) {
    throw new RangeError(`the GLB refers to part ${number} of ${items.length}`);
  }
  return item;
}
