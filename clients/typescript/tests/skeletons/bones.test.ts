import assert from "node:assert/strict";
import { test } from "node:test";

import { BONE_MAPS, foundBones } from "../../src/skeletons/bones.js";

test("every rig of the service is found by all of its own names", () => {
  for (const [rig, table] of Object.entries(BONE_MAPS)) {
    assert.deepEqual(foundBones(Object.values(table)), table, rig);
  }
});

test("names are found as three.js changes them, and what the rig lacks is left out", () => {
  const bones = foundBones(
    Object.values(BONE_MAPS["mixamorig"] ?? {})
      .map((name) => name.replace(":", ""))
      .filter((name) => !name.includes("Hand")),
  );
  assert.equal(bones["leftUpperArm"], "mixamorigLeftArm");
  assert.ok(!("leftHand" in bones));
});

test("bones of no known rig are refused with what would be right", () => {
  assert.throws(() => foundBones(["Bone", "Bone.001"]), /give a BoneMap/);
});
