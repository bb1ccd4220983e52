"""Kochanek-Bartels (tension, continuity, bias) splines through rotations, at arbitrary times.

Conventions: a `Curve` interpolates its own keys (K, 4) at its own increasing times (K,); curves are evaluated together,
and results are (T, C, 4). Before the first key and after the last the value is constant, with zero velocity. Tangents
are rotation vectors in the key's own space, so a spline does not depend on the world's axes.

The tangents are those of Kochanek and Bartels (1984) with differences in log space, as in Eberly's version for
quaternions. Differences: segments are cumulative Bézier curves (Kim, Kim & Shin 1995) instead of Eberly's squad, whose
inner control points go wrong when a key rotates by more than 90°; tangents are velocities, so that uneven key times
stay smooth (Kochanek & Bartels's own velocity correction); and a tangent is at most three times the slope on either
side, zero beside a repeated key, so holds are constant and curves do not overshoot (Fritsch & Carlson 1980).
"""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ...model import FloatArray
from .rotations import from_rotation_vector, inverse, length, multiply, to_rotation_vector, with_continuous_signs
from .trigonometry import sine_and_cosine

_MOST_SLOPE = 3.0
_STILL = 1e-9


@dataclass(frozen=True, slots=True, eq=False)
class Curve:
    """Keys (K, 4) at times (K,), and `shape` (K, 3): tension, continuity and bias at each, in [-1, 1]; zeros give a
    Catmull-Rom spline."""

    times_s: FloatArray
    keys: FloatArray
    shape: FloatArray


def splines(curves: Sequence[Curve], times_s: FloatArray) -> FloatArray:
    """The rotations (T, C, 4) of the curves at `times_s` (T,)."""
    curves = [curve if len(curve.times_s) > 1 else _of_two_keys(curve) for curve in curves]
    counts = [len(curve.times_s) for curve in curves]
    key_times_s = np.concatenate([curve.times_s for curve in curves])
    keys = with_continuous_signs(np.concatenate([curve.keys for curve in curves]))
    shape = np.concatenate([curve.shape for curve in curves])
    lasts = np.cumsum(counts, dtype=np.intp) - 1
    spans_s = np.diff(key_times_s)
    spans_s[lasts[:-1]] = 1.0
    turns = _turns(keys, spans_s[:, None], shape, lasts)
    segment = _segments(curves, (lasts - counts + 1).tolist(), times_s)
    found = keys.take(segment, axis=0)
    turning = np.sum([length(turn)[:, 0] for turn in turns], axis=0) > _STILL
    moving = np.flatnonzero(turning.take(segment))
    segment, times_s = segment.ravel().take(moving), times_s.take(moving // len(curves))
    share = np.minimum(np.maximum((times_s - key_times_s.take(segment)) / spans_s.take(segment), 0.0), 1.0)
    left, squared = 1 - share, share * share
    weights = (1 - left * left * left, squared * (3 - 2 * share), squared * share)
    way = np.ascontiguousarray(keys.T).take(segment, axis=1)
    for turn, weight in zip(turns, weights, strict=True):
        way = _product(way, _parts_of_turns(turn, segment, weight))
    found.reshape(-1, 4)[moving] = way.T
    return found


def _of_two_keys(curve: Curve) -> Curve:
    """A curve whose only key is repeated."""
    times_s = np.concatenate([curve.times_s, curve.times_s + 1.0])
    return Curve(times_s, np.repeat(curve.keys, 2, axis=0), np.repeat(curve.shape, 2, axis=0))


def _segments(curves: Sequence[Curve], firsts: Iterable[int], times_s: FloatArray) -> NDArray[np.intp]:
    """The index (T, C) of the last key that each curve has passed, in the concatenation of all curves' keys."""
    found = np.empty((len(times_s), len(curves)), dtype=np.intp)
    known: dict[bytes, NDArray[np.intp]] = {}
    for column, (curve, first) in enumerate(zip(curves, firsts, strict=True)):
        keyed_at = curve.times_s.tobytes()
        passed = known.get(keyed_at)
        if passed is None:
            passed = known[keyed_at] = curve.times_s[1:-1].searchsorted(times_s, side="right")
        found[:, column] = first + passed
    return found


def _turns(
    keys: FloatArray, spans_s: FloatArray, shape: FloatArray, lasts: NDArray[np.intp]
) -> tuple[FloatArray, FloatArray, FloatArray]:
    """The three rotation vectors (N-1, 3) of each segment's Bézier curve, for the concatenated keys (N, 4) of all
    curves; those between the last key of one curve and the first of the next are meaningless."""
    step = multiply(inverse(keys[:-1]), keys[1:])
    leaving, arriving = _tangents(to_rotation_vector(step), spans_s, shape)
    leaving[lasts[:-1] + 1] = 0.0
    arriving[lasts[:-1] - 1] = 0.0
    first, third = leaving * spans_s / 3, arriving * spans_s / 3
    onwards = multiply(from_rotation_vector(-first), multiply(step, from_rotation_vector(-third)))
    return first, to_rotation_vector(onwards), third


def _tangents(steps: FloatArray, spans_s: FloatArray, shape: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Velocities (N-1, 3) at which each segment leaves its first key and arrives at its second.

    Kochanek & Bartels's equations 8 and 9 weigh the differences before and after a key; divided by the mean of the two
    spans they are velocities, equal on both sides of a key with continuity 0.
    """
    tension, continuity, bias = (shape[1:-1, part, None] for part in range(3))
    before, after = steps[:-1], steps[1:]
    scale = (1 - tension) / (spans_s[:-1] + spans_s[1:])
    leaving = scale * ((1 + bias) * (1 + continuity) * before + (1 - bias) * (1 - continuity) * after)
    arriving = scale * ((1 + bias) * (1 - continuity) * before + (1 - bias) * (1 + continuity) * after)
    most = _MOST_SLOPE * np.minimum(length(before / spans_s[:-1]), length(after / spans_s[1:]))
    at_rest = np.zeros((1, 3))
    return np.concatenate([at_rest, _at_most(leaving, most)]), np.concatenate([_at_most(arriving, most), at_rest])


def _at_most(vector: FloatArray, longest: FloatArray) -> FloatArray:
    return np.asarray(vector * np.minimum(1.0, longest / np.maximum(length(vector), 1e-12)))


def _parts_of_turns(turns: FloatArray, segment: NDArray[np.intp], weight: FloatArray) -> FloatArray:
    """The rotations by `weight` (M,) of the rotation vector (N, 3) of each segment (M,), as four arrays (4, M).

    Axes are computed once per segment and components kept in separate arrays, because most of the realizer's time is
    spent here.
    """
    angle = length(turns)
    axis = np.ascontiguousarray((turns / np.maximum(angle, 1e-12)).T)
    half = (0.5 * angle[:, 0]).take(segment) * weight
    found = np.empty((4, *half.shape))
    sine, found[3] = sine_and_cosine(half)
    np.multiply(axis.take(segment, axis=1), sine, out=found[:3])
    return found


def _product(a: FloatArray, b: FloatArray) -> FloatArray:
    """`rotations.multiply` of (4, M)."""
    (ax, ay, az, aw), (bx, by, bz, bw) = a, b
    product = np.empty_like(b)
    product[0] = aw * bx + ax * bw + ay * bz - az * by
    product[1] = aw * by - ax * bz + ay * bw + az * bx
    product[2] = aw * bz + ax * by - ay * bx + az * bw
    product[3] = aw * bw - ax * bx - ay * by - az * bz
    return product
