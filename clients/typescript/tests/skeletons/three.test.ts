/** Clips on figures of three.js, against what three.js itself plays of the service's GLB files. */

import assert from "node:assert/strict";
import { after, before, describe, test } from "node:test";
import { AnimationMixer, Mesh, Vector3, type Object3D } from "three";
import { GLTFLoader, type GLTF } from "three/examples/jsm/loaders/GLTFLoader.js";

import type { Clip } from "../../src/motion/clip.js";
import { clipFromJson } from "../../src/motion/clip_json.js";
import { clipFromGlb } from "../../src/motion/glb.js";
import { sampled } from "../../src/motion/sampling.js";
import type { LocalService } from "../../src/node/local_service.js";
import { UnderstudyClient } from "../../src/service/client.js";
import { Retargeting } from "../../src/skeletons/retargeting.js";
import { rigFromThree } from "../../src/skeletons/three.js";
import { avatarGlb } from "../support/avatar.js";
import { assertNear } from "../support/near.js";
import { noService, recorded, startService } from "../support/service.js";

const TIMES_S = [0, 0.4, 1.1, 2.03, 3];
const TOLERANCE_M = 0.001;

function loaded(file: ArrayBuffer): Promise<GLTF> {
  return new GLTFLoader().parseAsync(file.slice(0), "");
}

/** Where everything of a scene is, by name, and the weights of its meshes. */
function seen(scene: Object3D): Map<string, number[]> {
  const found = new Map<string, number[]>();
  scene.updateMatrixWorld(true);
  scene.traverse((object) => {
    found.set(object.name, object.getWorldPosition(new Vector3()).toArray());
    if (object instanceof Mesh && object.morphTargetInfluences) {
      found.set(`${object.name} weights`, object.morphTargetInfluences);
    }
  });
  return found;
}

/** What three.js plays of the file at a time. */
async function played(file: ArrayBuffer, timeS: number): Promise<Map<string, number[]>> {
  const { scene, animations } = await loaded(file);
  const mixer = new AnimationMixer(scene);
  for (const animation of animations) {
    mixer.clipAction(animation).play();
  }
  mixer.setTime(timeS);
  return seen(scene);
}

describe("a clip in three.js", { skip: noService }, () => {
  let service: LocalService;
  let client: UnderstudyClient;
  let line: { bml: string; audio: Uint8Array<ArrayBuffer> };
  let clip: Clip;

  before(async () => {
    service = await startService();
    client = new UnderstudyClient({ baseUrl: service.baseUrl });
    const recording = await recorded("figure8");
    line = { bml: (await client.performBml(recording)).content, audio: recording.audio };
    clip = clipFromJson(await client.realize(line));
  });
  after(() => service.stop());

  async function assertPlaysLike(body: ArrayBuffer, expected: ArrayBuffer, eyeLook: boolean): Promise<void> {
    const { scene } = await loaded(body);
    const retargeting = new Retargeting(rigFromThree(scene), clip.joints, { eyeLook });
    for (const timeS of TIMES_S) {
      retargeting.show(sampled(clip, timeS));
      const found = seen(scene);
      for (const [name, values] of await played(expected, timeS)) {
        assertNear(found.get(name) ?? [], values, TOLERANCE_M);
      }
    }
  }

  test("the mannequin stands and looks as three.js plays its own file", async () => {
    const { content } = await client.realizeGlb(line);
    await assertPlaysLike(content, content, true);
  });

  for (const rig of ["mixamorig", "unreal"]) {
    test(`an avatar with ${rig} names, another unit, rest pose and axes stands as the service retargets it`, async () => {
      const avatar = avatarGlb(clip.joints, rig);
      const { content } = await client.realizeGlb({ ...line, avatar: new Uint8Array(avatar) });
      await assertPlaysLike(avatar, content, false);
    });
  }

  test("the clip of the GLB is that of the JSON, with baked and with sparse keys", async () => {
    for (const [keys, tolerance] of [["baked", 0.0001], ["sparse", 0.021]] as const) {
      const glb = clipFromGlb((await client.realizeGlb({ ...line, options: { keys } })).content);
      assert.deepEqual(glb.joints.map(({ name, parent }) => [name, parent]), clip.joints.map(({ name, parent }) => [name, parent]));
      assertNear([glb.durationS, glb.audioOffsetS], [clip.durationS, clip.audioOffsetS], 1e-5);
      for (const timeS of TIMES_S) {
        const [pose, expected] = [sampled(glb, timeS), sampled(clip, timeS)];
        assertNear(pose.hipsM, expected.hipsM, tolerance);
        for (const [name, turn] of expected.turns) {
          const other = pose.turns.get(name) ?? [0, 0, 0, 0];
          assertNear([Math.abs(turn.reduce((sum, part, axis) => sum + part * (other[axis] ?? 0), 0))], [1], tolerance);
        }
        assertNear([...pose.shapes.values()], [...expected.shapes.keys()].map((name) => expected.shapes.get(name) ?? -1), tolerance);
      }
    }
  });

  test("files that are no GLB, or have no animation, and clips of other versions and names are refused", async () => {
    assert.throws(() => clipFromGlb(new ArrayBuffer(8)), /not a GLB/);
    assert.throws(() => clipFromGlb(avatarGlb(clip.joints, "unreal")), RangeError);
    const mixamo = await client.realize({ ...line, options: { skeleton: "mixamo" } });
    assert.throws(() => clipFromJson(mixamo), /without the option skeleton/);
    assert.throws(() => clipFromJson({ ...mixamo, version: 2 }), /version 2/);
  });
});
