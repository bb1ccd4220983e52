"""Kochanek-Bartels (tension, continuity, bias) splines through rotations, at any times.

Conventions: keys (K, C, 4) of C channels share their times (K,), rising; results are (T, C, 4). Before the first key
and after the last the value rests, and the speed there is zero. Tangents are rotation vectors in the key's own space,
so a spline does not depend on the world's axes.

The tangents are Kochanek and Bartels's (1984) with the differences in log space, as Eberly has them for quaternions.
Departures: between keys runs a cumulative Bézier curve (Kim, Kim & Shin 1995) instead of Eberly's squad, which takes
its inner way round wrongly once a key turns by more than 90°; tangents are speeds, so that uneven times do not break
the smoothness (Kochanek & Bartels's own correction of the speed); and a tangent is at most three times the slope on
either side, zero beside a key that is repeated, so holds stay and curves do not swing out (Fritsch & Carlson 1980).
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from app.model import FloatArray
from app.realizer.rotations import from_rotation_vector, inverse, multiply, of_one_sign, to_rotation_vector

_MOST_SLOPE = 3.0


@dataclass(frozen=True, slots=True, eq=False)
class Shape:
    """Tension, continuity and bias (K,) of each key, in [-1, 1]; zero is the Catmull-Rom spline."""

    tension: FloatArray
    continuity: FloatArray
    bias: FloatArray

    @classmethod
    def even(cls, keys: int) -> "Shape":
        return cls(np.zeros(keys), np.zeros(keys), np.zeros(keys))


def spline(key_times_s: FloatArray, keys: FloatArray, shape: Shape, times_s: FloatArray) -> FloatArray:
    """The rotations (T, C, 4) at `times_s` (T,) on the way through `keys` (K, C, 4) at `key_times_s` (K,)."""
    if len(keys) == 1:
        return np.repeat(keys, len(times_s), axis=0)
    keys = of_one_sign(keys)
    spans_s = np.diff(key_times_s)[:, None, None]
    steps = to_rotation_vector(multiply(inverse(keys[:-1]), keys[1:]))
    leaving, arriving = _tangents(steps, spans_s, shape)
    segment = np.clip(np.searchsorted(key_times_s, times_s, side="right") - 1, 0, len(spans_s) - 1)
    share = np.clip((times_s - key_times_s[segment]) / spans_s[segment, 0, 0], 0.0, 1.0)[:, None]
    first, third = leaving * spans_s / 3, arriving * spans_s / 3
    onwards = multiply(
        from_rotation_vector(-first), multiply(from_rotation_vector(steps), from_rotation_vector(-third))
    )
    found = keys[segment]
    weights = (1 - (1 - share) ** 3, share**2 * (3 - 2 * share), share**3)
    for turn, weight in zip((first, to_rotation_vector(onwards), third), weights, strict=True):
        found = multiply(found, _parts_of_turns(turn, segment, weight))
    return found


def _tangents(steps: FloatArray, spans_s: FloatArray, shape: Shape) -> tuple[FloatArray, FloatArray]:
    """Speeds (K-1, C, 3) with which each segment leaves its first key and arrives at its second.

    Kochanek & Bartels's equations 8 and 9 weigh the steps before and after a key; divided by the mean of the two spans
    they are speeds, the same on both sides of a key whose continuity is 0.
    """
    tension, continuity, bias = (part[1:-1, None, None] for part in (shape.tension, shape.continuity, shape.bias))
    before, after = steps[:-1], steps[1:]
    scale = (1 - tension) / (spans_s[:-1] + spans_s[1:])
    leaving = scale * ((1 + bias) * (1 + continuity) * before + (1 - bias) * (1 - continuity) * after)
    arriving = scale * ((1 + bias) * (1 - continuity) * before + (1 - bias) * (1 + continuity) * after)
    most = _MOST_SLOPE * np.minimum(
        np.linalg.norm(before / spans_s[:-1], axis=-1, keepdims=True),
        np.linalg.norm(after / spans_s[1:], axis=-1, keepdims=True),
    )
    at_rest = np.zeros((1, *steps.shape[1:]))
    return np.concatenate([at_rest, _at_most(leaving, most)]), np.concatenate([_at_most(arriving, most), at_rest])


def _at_most(vector: FloatArray, longest: FloatArray) -> FloatArray:
    length = np.linalg.norm(vector, axis=-1, keepdims=True)
    return np.asarray(vector * np.minimum(1.0, longest / np.maximum(length, 1e-12)))


def _parts_of_turns(turns: FloatArray, segment: NDArray[np.intp], weight: FloatArray) -> FloatArray:
    """The rotations (T, C, 4) by `weight` (T, 1) of the turn (K-1, C, 3) of each time's segment: axes are worked out
    once a segment, not once a frame."""
    angle = np.linalg.norm(turns, axis=-1)
    axis = turns / np.maximum(angle, 1e-12)[..., None]
    half = 0.5 * angle[segment] * weight
    found = np.empty((*half.shape, 4))
    found[..., :3] = axis[segment] * np.sin(half)[..., None]
    found[..., 3] = np.cos(half)
    return found
