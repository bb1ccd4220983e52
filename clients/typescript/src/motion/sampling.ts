/** Clips at any time: before the first key as at it, after the last as at that, between keys along the straight way. */

import type { Clip, Pose, Track } from "./clip.js";
import { add, between, scaled, type Quaternion, type Vector } from "./vectors.js";

/** The pose `timeS` after the first frame. */
export function sampled(clip: Clip, timeS: number): Pose {
  return {
    hipsM: vectorAt(clip.hips, timeS),
    turns: mapped(clip.turns, (track) => turnAt(track, timeS)),
    shapes: mapped(clip.shapes, (track) => numberAt(track, timeS)),
    visemes: mapped(clip.visemes, (track) => numberAt(track, timeS)),
  };
}

/** `share` of the way from one pose to another. What only one of them has is as there. */
export function blended(from: Pose, to: Pose, share: number): Pose {
  return {
    hipsM: add(scaled(from.hipsM, 1 - share), scaled(to.hipsM, share)),
    turns: merged(from.turns, to.turns, (a, b) => between(a, b, share)),
    shapes: merged(from.shapes, to.shapes, (a, b) => a + share * (b - a)),
    visemes: merged(from.visemes, to.visemes, (a, b) => a + share * (b - a)),
  };
}

interface Place {
  readonly before: number;
  readonly after: number;
  readonly share: number;
}

function vectorAt(track: Track, timeS: number): Vector {
  const { before, after, share } = placeOf(track.timesS, timeS);
  return add(scaled(vectorKey(track, before), 1 - share), scaled(vectorKey(track, after), share));
}

function turnAt(track: Track, timeS: number): Quaternion {
  const { before, after, share } = placeOf(track.timesS, timeS);
  return between(turnKey(track, before), turnKey(track, after), share);
}

function numberAt({ timesS, values }: Track, timeS: number): number {
  const { before, after, share } = placeOf(timesS, timeS);
  return key(values, before) * (1 - share) + key(values, after) * share;
}

/** The keys around a time, by halving. */
function placeOf(timesS: Float32Array, timeS: number): Place {
  let before = 0;
  let after = timesS.length - 1;
  while (after - before > 1) {
    const middle = (before + after) >> 1;
    if (key(timesS, middle) <= timeS) {
      before = middle;
    } else {
      after = middle;
    }
  }
  const startS = key(timesS, before);
  const lengthS = key(timesS, after) - startS;
  return { before, after, share: lengthS > 0 ? Math.min(1, Math.max(0, (timeS - startS) / lengthS)) : 0 };
}

function vectorKey({ values }: Track, number: number): Vector {
  return [key(values, 3 * number), key(values, 3 * number + 1), key(values, 3 * number + 2)];
}

function turnKey({ values }: Track, number: number): Quaternion {
  const first = 4 * number;
  return [key(values, first), key(values, first + 1), key(values, first + 2), key(values, first + 3)];
}

function key(values: Float32Array, index: number): number {
  return values[index] ?? 0;
}

function mapped<Value, Result>(
  values: ReadonlyMap<string, Value>,
  change: (value: Value) => Result,
): ReadonlyMap<string, Result> {
  return new Map(Array.from(values, ([name, value]) => [name, change(value)]));
}

function merged<Value>(
  from: ReadonlyMap<string, Value>,
  to: ReadonlyMap<string, Value>,
  merge: (a: Value, b: Value) => Value,
): ReadonlyMap<string, Value> {
  const result = new Map(from);
  for (const [name, value] of to) {
    const other = from.get(name);
    result.set(name, other === undefined ? value : merge(other, value));
  }
  return result;
}
