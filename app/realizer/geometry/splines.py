"""Kochanek-Bartels (tension, continuity, bias) splines through rotations, at arbitrary times.

Conventions: a curve interpolates its own keys (K, 4) at its own increasing times (K,); curves are evaluated together,
and results are (T, C, 4). Before the first key and after the last the value is constant, with zero velocity. Tangents
are rotation vectors in the key's own space, so a spline does not depend on the world's axes.

The tangents are those of Kochanek and Bartels (1984) with differences in log space, as in Eberly's version for
quaternions. Differences: segments are cumulative Bézier curves (Kim, Kim & Shin 1995) instead of Eberly's squad, whose
inner control points go wrong when a key rotates by more than 90°; tangents are velocities, so that uneven key times
stay smooth (Kochanek & Bartels's own velocity correction); and a tangent is at most three times the slope on either
side, zero beside a repeated key, so holds are constant and curves do not overshoot (Fritsch & Carlson 1980).
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ...model import FloatArray
from .rotations import (
    from_rotation_vector,
    inverse,
    multiply,
    multiply_parts,
    sine_and_cosine,
    to_rotation_vector,
    with_continuous_signs,
)

_MOST_SLOPE = 3.0
_STILL = 1e-9


@dataclass(frozen=True, slots=True, eq=False)
class Curves:
    """Several curves, one after the other: their keys (N, 4) at times (N,), `shape` (N, 3), which is tension,
    continuity and bias at each, in [-1, 1], zeros for a Catmull-Rom spline; and how many keys each curve has (C,), at
    least one."""

    times_s: FloatArray
    keys: FloatArray
    shape: FloatArray
    counts: NDArray[np.intp]

    @classmethod
    def joined(cls, several: Sequence["Curves"]) -> "Curves":
        """All curves of several."""
        return cls(*(np.concatenate([getattr(each, name) for each in several]) for name in cls.__slots__))


@dataclass(frozen=True, slots=True, eq=False)
class _Turn:
    """One of the three turns of each segment's Bézier curve: unit axes (3, N-1) and halves of the angles (N-1,)."""

    axes: FloatArray
    halves: FloatArray


@dataclass(frozen=True, slots=True, eq=False)
class Splines:
    """Curves made ready to be evaluated: `keys` (4, N), one part after the other. Segment k is that from key k to the
    next, and those between the last key of one curve and the first of the next are meaningless. `firsts` and `column`
    are the first key of each curve, and the curve of each key."""

    times_s: FloatArray
    keys: FloatArray
    spans_s: FloatArray
    turns: tuple[_Turn, ...]
    turning: NDArray[np.bool_]
    firsts: NDArray[np.intp]
    column: NDArray[np.intp]


def splines(curves: Curves) -> Splines:
    """The splines through the keys of the curves."""
    curves = _of_two_keys(curves)
    lasts = np.cumsum(curves.counts) - 1
    keys, spans_s = with_continuous_signs(curves.keys), np.diff(curves.times_s)
    spans_s[lasts[:-1]] = 1.0
    turns = _turns(keys, spans_s, curves.shape.T, lasts)
    sizes = [_length(turn) for turn in turns]
    return Splines(
        times_s=curves.times_s,
        keys=np.ascontiguousarray(keys.T),
        spans_s=spans_s,
        turns=tuple(_Turn(turn / np.maximum(size, 1e-12), 0.5 * size) for turn, size in zip(turns, sizes, strict=True)),
        turning=sizes[0] + sizes[1] + sizes[2] > _STILL,
        firsts=lasts - curves.counts + 1,
        column=np.repeat(np.arange(len(lasts)), curves.counts),
    )


def rotations_at(curves: Splines, times_s: FloatArray) -> FloatArray:
    """The rotations (T, C, 4) of the curves at increasing `times_s` (T,). In memory they are the four parts, of each
    the curves, one frame after another, since NumPy is several times as fast with what lies together."""
    segment = _segments(curves, times_s)
    found = curves.keys.take(segment, axis=1)
    moving = np.flatnonzero(curves.turning.take(segment))
    segment, times_s = segment.ravel().take(moving), times_s.take(moving % len(times_s))
    share = (times_s - curves.times_s.take(segment)) / curves.spans_s.take(segment)
    share = np.minimum(np.maximum(share, 0.0), 1.0)
    left, squared = 1 - share, share * share
    weights = (1 - left * left * left, squared * (3 - 2 * share), squared * share)
    each = found.reshape(4, -1)
    way = each.take(moving, axis=1)
    for turn, weight in zip(curves.turns, weights, strict=True):
        way = multiply_parts(way, _parts_of_turns(turn, segment, weight))
    each[:, moving] = way
    return found.transpose(2, 1, 0)


def _of_two_keys(curves: Curves) -> Curves:
    """The curves, with the key of one that has no other repeated a second later."""
    alone = curves.counts == 1
    if not alone.any():
        return curves
    row = np.repeat(np.arange(len(curves.times_s)), np.repeat(1 + alone, curves.counts))
    times_s = curves.times_s[row]
    times_s[1:] += row[1:] == row[:-1]
    return Curves(times_s, curves.keys[row], curves.shape[row], curves.counts + alone)


def _segments(curves: Splines, times_s: FloatArray) -> NDArray[np.intp]:
    """The index (C, T) of the last key that each curve has passed: never its last, and its first from the beginning."""
    inner = np.ones(len(curves.times_s), dtype=bool)
    inner[curves.firsts] = inner[curves.firsts - 1] = False
    passed = np.zeros((len(curves.firsts), len(times_s) + 1), dtype=np.intp)
    passed[:, 0] = curves.firsts
    np.add.at(passed, (curves.column[inner], times_s.searchsorted(curves.times_s[inner])), 1)
    return np.asarray(passed[:, :-1].cumsum(axis=1))


def _turns(
    keys: FloatArray, spans_s: FloatArray, shape: FloatArray, lasts: NDArray[np.intp]
) -> tuple[FloatArray, FloatArray, FloatArray]:
    """The three rotation vectors (3, N-1) of each segment's Bézier curve, for the concatenated keys (N, 4) of all
    curves and their shape (3, N); those between the last key of one curve and the first of the next are
    meaningless."""
    step = multiply(inverse(keys[:-1]), keys[1:])
    leaving, arriving = _tangents(np.ascontiguousarray(to_rotation_vector(step).T), spans_s, shape)
    leaving[:, lasts[:-1] + 1] = 0.0
    arriving[:, lasts[:-1] - 1] = 0.0
    first, third = leaving * (spans_s / 3), arriving * (spans_s / 3)
    back, ahead = from_rotation_vector(np.array((first.T, third.T)) * -1.0)
    onwards = multiply(back, multiply(step, ahead))
    return first, np.ascontiguousarray(to_rotation_vector(onwards).T), third


def _tangents(steps: FloatArray, spans_s: FloatArray, shape: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Velocities (3, N-1) at which each segment leaves its first key and arrives at its second.

    Kochanek & Bartels's equations 8 and 9 weigh the differences before and after a key; divided by the mean of the two
    spans they are velocities, equal on both sides of a key with continuity 0.
    """
    tension, continuity, bias = shape[:, 1:-1]
    before, after = steps[:, :-1], steps[:, 1:]
    scale = (1 - tension) / (spans_s[:-1] + spans_s[1:])
    of_before, of_after = scale * (1 + bias), scale * (1 - bias)
    most = _length(steps) / spans_s
    most = _MOST_SLOPE * np.minimum(most[:-1], most[1:])
    found = np.zeros((2, *steps.shape))
    found[0, :, 1:] = _at_most(of_before * (1 + continuity) * before + of_after * (1 - continuity) * after, most)
    found[1, :, :-1] = _at_most(of_before * (1 - continuity) * before + of_after * (1 + continuity) * after, most)
    return found[0], found[1]


def _at_most(vector: FloatArray, longest: FloatArray) -> FloatArray:
    return np.asarray(vector * np.minimum(1.0, longest / np.maximum(_length(vector), 1e-12)))


def _length(vector: FloatArray) -> FloatArray:
    """The lengths (N,) of vectors (3, N)."""
    x, y, z = vector
    return np.asarray(np.sqrt(x * x + y * y + z * z))


def _parts_of_turns(turn: _Turn, segment: NDArray[np.intp], weight: FloatArray) -> FloatArray:
    """The rotations by `weight` (M,) of the turn of each segment (M,), as four arrays (4, M): most of the realizer's
    time is spent here."""
    half = turn.halves.take(segment)
    half *= weight
    found = np.empty((4, *half.shape))
    sine, found[3] = sine_and_cosine(half)
    np.multiply(turn.axes.take(segment, axis=1), sine, out=found[:3])
    return found
