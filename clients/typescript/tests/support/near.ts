import assert from "node:assert/strict";

/** Fails where any two numbers are further apart than `tolerance`. */
export function assertNear(found: readonly number[], expected: readonly number[], tolerance = 1e-6): void {
  assert.equal(found.length, expected.length);
  for (const [index, number] of found.entries()) {
    const apart = Math.abs(number - (expected[index] ?? Number.NaN));
    assert.ok(apart <= tolerance, `[${found.join(", ")}] is not [${expected.join(", ")}] within ${tolerance}`);
  }
}
