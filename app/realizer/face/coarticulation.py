"""Coarticulation by dominance (Cohen & Massaro 1993): how much say each phone has over each articulator, and when.

Every phone dominates an articulator by a strength that falls off as a negative exponential of the distance in time;
what the articulator does is the mean of the phones' targets, weighted by their dominance. So a T, which says next to
nothing of the lips, is said with the lips of the vowel beside it, and a P closes them whatever stands there.

Departures from the paper of 1993: the distance is counted from the phone's inner part, not from its middle, so that
long phones keep their shape; it is rounded off there, so that nothing turns a corner; and beyond `HORIZON_S` it is
exactly nothing, so that a moment depends on few phones. Departure from §3.8 of ours, which sequences hand-made curves
of diphones: they are not public; dominance does for every pair of phones what they do for some.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ...model import FloatArray
from .face_tables import Dominance

HORIZON_S = 0.45

_SOFTENING_S = 0.004
_FRAMES_AT_ONCE = 64

Numbers = NDArray[np.int64]


@dataclass(frozen=True, slots=True, eq=False)
class Segments:
    """Phones one after the other without gaps: `kind` is the row of the dominance table, bounds are in seconds, and
    `weight`, in (0, 1], tells how much of its dominance each has."""

    kind: Numbers
    start_s: FloatArray
    end_s: FloatArray
    weight: FloatArray

    def between(self, start_s: float, end_s: float) -> slice:
        """Which of them are at least partly there."""
        return slice(int(np.searchsorted(self.end_s, start_s)), int(np.searchsorted(self.start_s, end_s, side="right")))


def blend(
    dominance: Dominance, segments: Segments, targets: FloatArray, articulator: Numbers, times_s: FloatArray
) -> FloatArray:
    """The mean (T, channels) of `targets` (segments, channels), each weighted by dominance over its articulator."""
    blended = np.empty((len(times_s), targets.shape[1]))
    for first in range(0, len(times_s), _FRAMES_AT_ONCE):
        frames = slice(first, first + _FRAMES_AT_ONCE)
        at_s = times_s[frames]
        near = segments.between(float(at_s[0]) - HORIZON_S, float(at_s[-1]) + HORIZON_S)
        weights = _weights(dominance, segments, near, at_s)
        for number, weight in enumerate(weights / weights.sum(axis=-1, keepdims=True)):
            blended[frames, articulator == number] = weight @ targets[near][:, articulator == number]
    return blended


def _weights(dominance: Dominance, segments: Segments, near: slice, at_s: FloatArray) -> FloatArray:
    """The dominance (articulators, T, segments) at each moment of the segments in `near`."""
    kind, start_s, end_s = segments.kind[near], segments.start_s[near], segments.end_s[near]
    strength, before_s, after_s = (
        table[kind].T[:, None] for table in (dominance.strength, dominance.before_s, dominance.after_s)
    )
    ahead_s, behind_s = start_s - at_s[:, None], at_s[:, None] - end_s
    within = np.maximum(1 - (np.maximum(np.maximum(ahead_s, behind_s), 0) / HORIZON_S) ** 2, 0)
    inset_s = np.minimum(dominance.inset_s[:, None, None], (end_s - start_s) / 2)
    fading = _softened(ahead_s + inset_s) / before_s + _softened(behind_s + inset_s) / after_s
    return np.asarray(strength * np.exp(-fading) * within * segments.weight[near])


def _softened(distance_s: FloatArray) -> FloatArray:
    """The positive part, without a corner."""
    positive = np.maximum(distance_s, 0)
    return np.asarray(np.sqrt(positive * positive + _SOFTENING_S**2) - _SOFTENING_S)
