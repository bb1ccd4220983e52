"""Coarticulation with dominance functions (Cohen & Massaro 1993): how phones share each articulator over time.

Every phone dominates an articulator with a strength that decays exponentially with the distance in time; the
articulator's position is the mean of the phones' targets, weighted by dominance. So a T, which hardly constrains the
lips, is produced with the lips of its neighbouring vowel, and a P closes them in any context.

Differences from the 1993 paper: the distance is measured from the inner part of a phone instead of its centre, so that
long phones keep their shape; it is smoothed there, so that curves have no corners; and beyond `HORIZON_S` dominance is
exactly zero, so that each moment depends on few phones. Difference from our paper's §3.8, which concatenates hand-made
diphone curves: these are not public, and dominance covers every pair of phones.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ...model import FloatArray
from .face_tables import Dominance

HORIZON_S = 0.45

_SOFTENING_S = 0.004
_FRAMES_AT_ONCE = 96

Numbers = NDArray[np.int64]


@dataclass(frozen=True, slots=True, eq=False)
class Segments:
    """Contiguous phones: `kind` is the row of the dominance table, bounds are in seconds, and `weight` in (0, 1] scales
    the dominance of each."""

    kind: Numbers
    start_s: FloatArray
    end_s: FloatArray
    weight: FloatArray

    def between(self, start_s: float, end_s: float) -> slice:
        """The segments that overlap the interval."""
        return slice(int(np.searchsorted(self.end_s, start_s)), int(np.searchsorted(self.start_s, end_s, side="right")))


def blend(
    dominance: Dominance, segments: Segments, targets: FloatArray, articulator: Numbers, times_s: FloatArray
) -> FloatArray:
    """The mean (T, channels) of `targets` (segments, channels), each weighted by the dominance over its articulator."""
    order = np.argsort(articulator, kind="stable")
    targets, bounds = targets.take(order, axis=1), np.searchsorted(articulator[order], np.arange(articulator.max() + 2))
    blended = np.empty((len(times_s), targets.shape[1]))
    for first in range(0, len(times_s), _FRAMES_AT_ONCE):
        frames = slice(first, first + _FRAMES_AT_ONCE)
        at_s = times_s[frames]
        near = segments.between(float(at_s[0]) - HORIZON_S, float(at_s[-1]) + HORIZON_S)
        weights = _weights(dominance, segments, near, at_s)
        weights /= weights.sum(axis=-1, keepdims=True)
        for weight, first_channel, past in zip(weights, bounds, bounds[1:], strict=False):
            blended[frames, first_channel:past] = weight @ targets[near, first_channel:past]
    return blended.take(np.argsort(order), axis=1)


def _weights(dominance: Dominance, segments: Segments, near: slice, at_s: FloatArray) -> FloatArray:
    """The dominance (articulators, T, segments) of the segments in `near` at each time."""
    kind, start_s, end_s = segments.kind[near], segments.start_s[near], segments.end_s[near]
    strength = dominance.strength[kind].T[:, None]
    decays = -1 / np.stack((dominance.before_s[kind].T, dominance.after_s[kind].T))[:, :, None]
    away_s = np.stack((start_s - at_s[:, None], at_s[:, None] - end_s))
    within = np.maximum(1 - (np.maximum(away_s.max(axis=0), 0) / HORIZON_S) ** 2, 0)
    within *= segments.weight[near]
    inset_s = np.minimum(dominance.inset_s[:, None, None], (end_s - start_s) / 2)
    decayed = _softened(away_s[:, None] + inset_s)
    decayed *= decays
    left = np.exp(decayed.sum(axis=0))
    left *= strength
    left *= within
    return np.asarray(left)


def _softened(distance_s: FloatArray) -> FloatArray:
    """A smooth approximation of the positive part, in the same memory."""
    np.maximum(distance_s, 0, out=distance_s)
    np.square(distance_s, out=distance_s)
    distance_s += _SOFTENING_S**2
    np.sqrt(distance_s, out=distance_s)
    distance_s -= _SOFTENING_S
    return distance_s
