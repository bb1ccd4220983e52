import assert from "node:assert/strict";
import { test } from "node:test";

import { Quaternion, Vector3 } from "three";

import { lookingAside } from "../../../app/studio/page/table_read/looking.js";

test("the head looks so far to its left, be it nodding or not, and nothing else is moved", () => {
  const nod = /** @type {const} */ ([Math.sin(0.1), 0, 0, Math.cos(0.1)]);
  const pose = { hipsM: /** @type {const} */ ([0, 1, 0]), turns: new Map([["head", nod], ["chest", nod]]), shapes: new Map(), visemes: new Map() };
  const { turns } = lookingAside(pose, 0.5);
  const [neck, head] = ["neck", "head"].map((joint) => new Quaternion(...(turns.get(joint) ?? [NaN, 0, 0, 0])));
  const ahead = new Vector3(0, 0, 1).applyQuaternion(/** @type {Quaternion} */ (neck).multiply(/** @type {Quaternion} */ (head)));
  assert.ok(Math.abs(Math.atan2(ahead.x, ahead.z) - 0.5) < 1e-9);
  assert.ok(Math.abs(ahead.y + Math.sin(0.2)) < 1e-9);
  assert.deepEqual(turns.get("chest"), nod);
});
