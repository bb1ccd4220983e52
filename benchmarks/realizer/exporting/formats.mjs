// What others make of our motion files: Khronos' validator, and three.js's readers of glTF, BVH and FBX.
//
//     node benchmarks/realizer/exporting/formats.mjs NODE_MODULES FRAME_RATE_HZ FILE...
//
// Prints one JSON object: for each file the validator's counts, or the world positions of its joints in some frames
// (metres in glTF and FBX, centimetres in BVH), by joint name.

import fs from 'node:fs';
import path from 'node:path';
import { pathToFileURL } from 'node:url';

const [, , modules, rate, ...files] = process.argv;
const load = (name) => import(pathToFileURL(path.join(modules, name)).href);
globalThis.self = globalThis;
const THREE = await load('three/build/three.module.js');
const { GLTFLoader } = await load('three/examples/jsm/loaders/GLTFLoader.js');
const { BVHLoader } = await load('three/examples/jsm/loaders/BVHLoader.js');
const { FBXLoader } = await load('three/examples/jsm/loaders/FBXLoader.js');
const validator = (await load('gltf-validator/index.js')).default;
const STEP = 7;

function positions(root, clip, frameRate) {
  const mixer = new THREE.AnimationMixer(root);
  mixer.clipAction(clip).setLoop(THREE.LoopOnce).play();
  const found = {};
  for (let frame = 0; frame / frameRate < clip.duration; frame += STEP) {
    mixer.setTime(frame / frameRate);
    root.updateMatrixWorld(true);
    const seen = new Set(); // FBXLoader has a bone once for every mesh that it moves, one in the other
    root.traverse((node) => {
      if (seen.has(node.name)) return;
      seen.add(node.name);
      const at = new THREE.Vector3().setFromMatrixPosition(node.matrixWorld);
      (found[node.name] ??= []).push(at.toArray());
    });
  }
  return found;
}

async function readBinary(content) {
  const report = await validator.validateBytes(new Uint8Array(content), { maxIssues: 1000 });
  const bytes = content.buffer.slice(content.byteOffset, content.byteOffset + content.byteLength);
  const gltf = await new GLTFLoader().parseAsync(bytes, '');
  const { numErrors, numWarnings } = report.issues;
  const unlike = [...new Set(report.issues.messages.filter((each) => each.severity < 2).map((each) => each.code))];
  return { errors: numErrors, warnings: numWarnings, codes: unlike, joints: positions(gltf.scene, gltf.animations[0], rate) };
}

function readBvh(content) {
  const { skeleton, clip } = new BVHLoader().parse(content.toString());
  const root = new THREE.Group();
  root.add(skeleton.bones[0]);
  return { joints: positions(root, clip, rate) };
}

function readFbx(content) {
  const bytes = content.buffer.slice(content.byteOffset, content.byteOffset + content.byteLength);
  const root = new FBXLoader().parse(bytes, '');
  const [clip] = root.animations;
  return { duration_s: clip.duration, joints: positions(root, clip, rate) };
}

const readers = { '.bvh': readBvh, '.fbx': readFbx };
const found = {};
for (const file of files) {
  const content = fs.readFileSync(file);
  found[path.extname(file)] = await (readers[path.extname(file)] ?? readBinary)(content);
}
console.log(JSON.stringify(found));
