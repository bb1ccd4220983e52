"""Phases of a motion by the speed of the wrists: movements between minima, holds where they stand, rests where they
stay.

A hand is at rest where it is near the place in which it is still for the longest time. A unit is a stretch in which a
hand is away from rest. Its movements are parted at the minima of the speed; the first is the preparation, the last the
retraction, what lies between strokes. A stroke after a long hold begins a phrase, as does one that is larger than the
one before it; others are after-strokes. People correct it: the numbers are ours, and coarse. Times are seconds, speeds
metres a second.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import gaussian_filter1d
from scipy.signal import argrelmin

from ...model import FloatArray, Interval
from ..annotation.model import Phase, PhaseKind
from .bvh import WristPaths

SMOOTHED_S = 0.05
STILL_M_S = 0.12
LEAST_STILL_S = 0.15
AWAY_M = 0.15
"""How far from rest a hand is when it gestures."""
LEAST_UNIT_S, LEAST_MOVEMENT_S = 0.5, 0.1
LONG_HOLD_S = 0.35
LARGER = 1.5
CELL_M = 0.08

Flags = NDArray[np.bool_]
"""One a frame."""


@dataclass(frozen=True, slots=True)
class ProposedPhrase:
    """A gesture: its phases, and whether the left and right hand take part."""

    phases: tuple[Phase, ...]
    left: bool
    right: bool


@dataclass(frozen=True, slots=True)
class ProposedUnit:
    """A unit: its phrases and its retraction."""

    phrases: tuple[ProposedPhrase, ...]
    retraction: Phase


@dataclass(frozen=True, slots=True)
class _Movement:
    """A stretch of frames in which a hand moves, and how far."""

    first: int
    last: int
    way_m: float


def proposed_units(wrists: WristPaths) -> Iterator[ProposedUnit]:
    """The units of a motion in order of time; hands that pass their rest without a stop end one there and begin the
    next."""
    rate_hz = wrists.frame_rate_hz
    speeds = [_speed(path_m, rate_hz) for path_m in (wrists.left_m, wrists.right_m)]
    away = [_away(path_m, speed) for path_m, speed in zip((wrists.left_m, wrists.right_m), speeds, strict=True)]
    speed = np.maximum(*speeds)
    stretches = list(_stretches(away[0] | away[1]))
    passed = [(one[1] + other[0]) // 2 for one, other in pairwise(stretches)]
    for stretch, *bounds in zip(stretches, [0, *passed], [*passed, len(speed) - 1], strict=False):
        first, last = _until_still(speed, *stretch)
        first, last = max(first, bounds[0]), min(last, bounds[1])
        movements = list(_movements(speed, first, last, rate_hz))
        if (last - first) / rate_hz >= LEAST_UNIT_S and len(movements) >= 2:
            yield _unit(movements, away, rate_hz)


def _speed(path_m: FloatArray, rate_hz: float) -> FloatArray:
    smooth = gaussian_filter1d(path_m, SMOOTHED_S * rate_hz, axis=0)
    return np.asarray(np.linalg.norm(np.gradient(smooth, axis=0), axis=1) * rate_hz)


def _away(path_m: FloatArray, speed: FloatArray) -> Flags:
    """Whether a hand is away from where it is still for the longest time (T,)."""
    still = path_m[speed < STILL_M_S]
    if not len(still):
        return np.ones(len(path_m), bool)
    cells, counts = np.unique(np.round(still / CELL_M).astype(int), axis=0, return_counts=True)
    rest_m = CELL_M * cells[counts.argmax()]
    return np.asarray(np.linalg.norm(path_m - rest_m, axis=1) > AWAY_M, bool)


def _stretches(flags: Flags) -> Iterator[tuple[int, int]]:
    """First and last frame of each stretch that is set."""
    edges = np.flatnonzero(np.diff(np.concatenate([[0], flags.astype(int), [0]])))
    yield from zip(edges[::2].tolist(), (edges[1::2] - 1).tolist(), strict=True)


def _until_still(speed: FloatArray, first: int, last: int) -> tuple[int, int]:
    """The stretch with the movements by which hands leave and reach their rest."""
    while first > 0 and speed[first] > STILL_M_S:
        first -= 1
    while last < len(speed) - 1 and speed[last] > STILL_M_S:
        last += 1
    return first, last


def _movements(speed: FloatArray, first: int, last: int, rate_hz: float) -> Iterator[_Movement]:
    """The movements of a stretch, parted by minima of the speed; those that are too short go with the one before."""
    for start, end in _stretches(speed[first : last + 1] >= STILL_M_S):
        minima = [start, *(m + start for m in argrelmin(speed[first + start : first + end + 1])[0]), end]
        deep = [m for m in minima[1:-1] if speed[first + m] < 0.6 * min(_peaks(speed[first:], minima, m))]
        for one, other in pairwise([start, *deep, end]):
            if (other - one) / rate_hz >= LEAST_MOVEMENT_S:
                yield _Movement(first + one, first + other, float(speed[first + one : first + other].sum() / rate_hz))


def _peaks(speed: FloatArray, minima: Sequence[int], minimum: int) -> tuple[float, float]:
    """The greatest speeds before and after a minimum, up to its neighbours."""
    place = minima.index(minimum)
    before, after = minima[place - 1], minima[place + 1]
    return float(speed[before : minimum + 1].max()), float(speed[minimum : after + 1].max())


def _unit(movements: Sequence[_Movement], away: Sequence[Flags], rate_hz: float) -> ProposedUnit:
    back = movements[-1]
    strokes = movements[1:-1] or movements[:1]
    preparation = movements[0] if len(movements) > 2 else None
    groups: list[list[_Movement]] = []
    for before, stroke in zip([None, *strokes], strokes, strict=False):
        starts = before is None or _starts_phrase(before, stroke, rate_hz)
        groups.append([stroke]) if starts else groups[-1].append(stroke)
    ends = [*(group[0].first for group in groups[1:]), back.first]
    begins = [preparation.first if preparation else groups[0][0].first, *ends[:-1]]
    phrases = tuple(
        _phrase(group, preparation if not number else None, (begins[number], ends[number]), away, rate_hz)
        for number, group in enumerate(groups)
    )
    return ProposedUnit(phrases, Phase(PhaseKind.RETRACTION, _interval(back.first, back.last, rate_hz)))


def _starts_phrase(before: _Movement, stroke: _Movement, rate_hz: float) -> bool:
    held_s = (stroke.first - before.last) / rate_hz
    return held_s >= LONG_HOLD_S or stroke.way_m > LARGER * before.way_m


def _phrase(
    strokes: Sequence[_Movement],
    preparation: _Movement | None,
    span: tuple[int, int],
    away: Sequence[Flags],
    rate_hz: float,
) -> ProposedPhrase:
    phases: list[Phase] = []
    at = span[0]
    if preparation is not None:
        phases.append(Phase(PhaseKind.PREPARATION, _interval(preparation.first, preparation.last, rate_hz)))
        at = preparation.last
    for stroke in strokes:
        if (stroke.first - at) / rate_hz >= LEAST_STILL_S:
            phases.append(Phase(PhaseKind.HOLD, _interval(at, stroke.first, rate_hz)))
        phases.append(Phase(PhaseKind.STROKE, _interval(stroke.first, stroke.last, rate_hz)))
        at = stroke.last
    if (span[1] - at) / rate_hz >= LEAST_STILL_S:
        phases.append(Phase(PhaseKind.HOLD, _interval(at, span[1], rate_hz)))
    taking = [bool(each[span[0] : span[1] + 1].mean() > 0.5) for each in away]
    left, right = taking if any(taking) else (False, True)
    return ProposedPhrase(tuple(phases), left, right)


def _interval(first: int, last: int, rate_hz: float) -> Interval:
    return Interval(round(first / rate_hz, 3), round(last / rate_hz, 3))
