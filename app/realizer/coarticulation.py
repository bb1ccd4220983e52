"""Coarticulation by dominance (Cohen & Massaro 1993): how much say each phone has over each articulator, and when.

Every phone dominates an articulator by a strength that falls off as a negative exponential of the distance in time;
what the articulator does is the mean of the phones' targets, weighted by their dominance. So a T, which says next to
nothing of the lips, is said with the lips of the vowel beside it, and a P closes them whatever stands there.

Departures from the paper of 1993: the distance is counted from the phone's inner part, not from its middle, so that
long phones keep their shape; it is rounded off there, so that nothing turns a corner; and beyond `HORIZON_S` it is
exactly nothing, so that a moment depends on few phones. Departure from §3.8 of ours, which sequences hand-made curves
of diphones: they are not public; dominance does for every pair of phones what they do for some.
"""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from app.model import FloatArray
from app.realizer.face_tables import Dominance

HORIZON_S = 0.45

_SOFTENING_S = 0.004

Numbers = NDArray[np.int64]


@dataclass(frozen=True, slots=True, eq=False)
class Segments:
    """Phones one after the other without gaps: `kind` is the row of the dominance table, bounds are in seconds."""

    kind: Numbers
    start_s: FloatArray
    end_s: FloatArray


def blend(
    dominance: Dominance, segments: Segments, targets: FloatArray, articulator: Numbers, times_s: FloatArray
) -> FloatArray:
    """The mean (T, channels) of `targets` (segments, channels), each weighted by dominance over its articulator."""
    total = np.zeros((len(times_s), dominance.strength.shape[1]))
    weighted = np.zeros((len(times_s), targets.shape[1]))
    for segment, weight in _neighbours(dominance, segments, times_s):
        total += weight
        weighted += weight[:, articulator] * targets[segment]
    return np.asarray(weighted / total[:, articulator])


def _neighbours(dominance: Dominance, segments: Segments, times_s: FloatArray) -> Iterator[tuple[Numbers, FloatArray]]:
    """For each moment the phone said then, the one before, the one behind and so on to the horizon: the number of the
    segment (T,) and its dominance (T, articulators), zero where there is none."""
    last = len(segments.kind) - 1
    now = np.clip(np.searchsorted(segments.start_s, times_s, side="right") - 1, 0, last)
    reach = _reach(segments)
    for step in range(-reach, reach + 1):
        segment = np.clip(now + step, 0, last)
        there = (now + step == segment)[:, None]
        yield segment, np.where(there, _weight(dominance, segments, segment, times_s), 0.0)


def _reach(segments: Segments) -> int:
    """The most segments that begin within a horizon after another's end, or end within one before its start."""
    number = np.arange(len(segments.kind))
    behind = np.searchsorted(segments.start_s, segments.end_s + HORIZON_S) - 1 - number
    before = number - np.searchsorted(segments.end_s, segments.start_s - HORIZON_S)
    return int(max(behind.max(), before.max()))


def _weight(dominance: Dominance, segments: Segments, segment: Numbers, times_s: FloatArray) -> FloatArray:
    kind = segments.kind[segment]
    start_s, end_s, at_s = (each[:, None] for each in (segments.start_s[segment], segments.end_s[segment], times_s))
    inset_s = np.minimum(dominance.inset_s, (end_s - start_s) / 2)
    ahead_s = _softened(start_s + inset_s - at_s)
    behind_s = _softened(at_s - end_s + inset_s)
    fading = ahead_s / dominance.before_s[kind] + behind_s / dominance.after_s[kind]
    outside_s = np.maximum(np.maximum(start_s - at_s, at_s - end_s), 0)
    within = np.maximum(1 - (outside_s / HORIZON_S) ** 2, 0)
    return np.asarray(dominance.strength[kind] * np.exp(-fading) * within)


def _softened(distance_s: FloatArray) -> FloatArray:
    """The positive part, without a corner."""
    positive = np.maximum(distance_s, 0)
    return np.asarray(np.hypot(positive, _SOFTENING_S) - _SOFTENING_S)
