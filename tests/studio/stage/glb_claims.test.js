import assert from "node:assert/strict";
import { test } from "node:test";

import { checkClaims } from "../../../app/studio/page/stage/glb_claims.js";

/** @param {unknown} document */
function glb(document) {
  const json = new TextEncoder().encode(JSON.stringify(document));
  const content = new ArrayBuffer(20 + json.length);
  const view = new DataView(content);
  view.setUint32(0, 0x46546c67, true);
  view.setUint32(12, json.length, true);
  new Uint8Array(content).set(json, 20);
  return content;
}

test("a body as bodies are is let through", () => {
  checkClaims(glb({ accessors: [{ count: 40_000 }], nodes: [{ children: [1, 2] }, { children: [3] }, {}, {}] }));
});

test("what is no binary glTF, or only its beginning, is refused with what would be right", () => {
  assert.throws(() => checkClaims(new ArrayBuffer(4)), /does not begin with “glTF”.*save the body anew as \.glb or \.vrm/);
  assert.throws(() => checkClaims(glb({ nodes: [] }).slice(0, 24)), /ends after 24 bytes/);
});

test("accessors that claim everything are refused", () => {
  for (const accessor of [{ count: 4e9 }, { count: 1, sparse: { count: 4e9 } }, { count: "x" }]) {
    assert.throws(() => checkClaims(glb({ accessors: [accessor] })), /elements/);
  }
});

test("nodes that come again below themselves, or below two, are refused", () => {
  for (const nodes of [[{ children: [0] }], [{ children: [1] }, { children: [0] }], [{ children: [2] }, { children: [2] }, {}]]) {
    assert.throws(() => checkClaims(glb({ nodes })), /no trees/);
  }
});
