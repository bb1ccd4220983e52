"""Proposes phases, phrases and units as tracks of an annotation, from the motion in a BVH file and optionally the
words.

Phases are derived from the speed of the wrists. A hand is at rest near the place where it is still for the longest
time. A unit is an interval in which a hand is away from rest. Its movements are separated at the minima of the speed,
with holds where the hand stands still: the first movement is the preparation, the last the retraction, the others are
strokes. A stroke begins a new phrase if it follows a long hold or is larger than the previous one; others are
after-strokes. The thresholds are ours and coarse, since the proposal is corrected manually.

Lexemes cannot be derived from speeds: every phrase has the lexeme `UNKNOWN`, which learning refuses. The proposed
affiliate is the word during which the main stroke ends.

Conventions: seconds, metres, metres per second, Y up; positions are in the frame of the root, so that walking and
turning do not move the hands. Files in centimetres are recognized by the length of the skeleton, joints by their names
in any rig.
"""

import re
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import gaussian_filter1d
from scipy.signal import argrelmin

from ..bvh import Bvh, read_bvh
from ..errors import InputError
from ..model import FloatArray, Interval
from .annotation.model import AnnotationError, AnnotationMistake, Phase, PhaseKind
from .annotation.tracks import Track, TrackSpan

WRISTS = {
    "left": re.compile(r"(l|left)[_.]?(wrist|hand)|(wrist|hand)[_.]?(l|left)"),
    "right": re.compile(r"(r|right)[_.]?(wrist|hand)|(wrist|hand)[_.]?(r|right)"),
}
"""The names of the wrist joints, in lower case and without a prefix that ends in a colon."""

TALLEST_M = 4.0
"""A skeleton with a greater total bone length is in centimetres."""
CENTIMETRE_M = 0.01


@dataclass(frozen=True, slots=True)
class WristPaths:
    """The wrists' positions (T, 3) relative to the root, and the frame rate in Hz."""

    frame_rate_hz: float
    left_m: FloatArray
    right_m: FloatArray


def read_wrists(content: bytes, path: Path) -> WristPaths:
    """The wrists of a file; raises AnnotationError for a file that is not BVH or has no recognized wrists."""
    try:
        bvh = read_bvh(content, "it")
    except InputError as error:
        raise AnnotationError([AnnotationMistake(path, error.message.removeprefix("it: "))]) from None
    places = [_place(bvh, side, path) for side in ("left", "right")]
    long = sum(float(np.abs(joint.offset).max()) for joint in bvh.joints[1:]) > TALLEST_M
    left, right = ((CENTIMETRE_M if long else 1.0) * _path(bvh, place) for place in places)
    return WristPaths(1 / bvh.frame_s, left, right)


def _place(bvh: Bvh, side: str, path: Path) -> int:
    for place, joint in enumerate(bvh.joints):
        if WRISTS[side].fullmatch(joint.name.rpartition(":")[2].lower().removeprefix("b_")):
            return place
    names = ", ".join(joint.name for joint in bvh.joints[:60])
    raise AnnotationError([AnnotationMistake(path, f"no joint is called {side} hand or wrist; there are {names}")])


def _path(bvh: Bvh, place: int) -> FloatArray:
    """The positions (T, 3) of a joint in the frame of the root."""
    position = np.zeros((len(bvh.values), 3))
    while bvh.joints[place].parent >= 0:
        position = position + bvh.joints[place].offset
        place = bvh.joints[place].parent
        if bvh.joints[place].parent >= 0:
            position = np.einsum("tij,tj->ti", bvh.rotations(place), position)
    return position


SMOOTHED_S = 0.05
STILL_M_S = 0.12
LEAST_STILL_S = 0.15
AWAY_M = 0.15
"""The minimum distance from rest of a gesturing hand."""
LEAST_UNIT_S, LEAST_MOVEMENT_S = 0.5, 0.1
LONG_HOLD_S = 0.35
LARGER = 1.5
CELL_M = 0.08

Flags = NDArray[np.bool_]
"""One value per frame."""


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
    """An interval of frames in which a hand moves, and the distance it moves."""

    first: int
    last: int
    way_m: float


def proposed_units(wrists: WristPaths) -> Iterator[ProposedUnit]:
    """The units of a motion in order of time. If a hand passes its rest without stopping, one unit ends there and the
    next begins."""
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
    """Whether a hand is away from the place where it is still for the longest time (T,)."""
    still = path_m[speed < STILL_M_S]
    if not len(still):
        return np.ones(len(path_m), bool)
    cells, counts = np.unique(np.round(still / CELL_M).astype(int), axis=0, return_counts=True)
    rest_m = CELL_M * cells[counts.argmax()]
    return np.asarray(np.linalg.norm(path_m - rest_m, axis=1) > AWAY_M, bool)


def _stretches(flags: Flags) -> Iterator[tuple[int, int]]:
    """The first and last frame of each run of set flags."""
    edges = np.flatnonzero(np.diff(np.concatenate([[0], flags.astype(int), [0]])))
    yield from zip(edges[::2].tolist(), (edges[1::2] - 1).tolist(), strict=True)


def _until_still(speed: FloatArray, first: int, last: int) -> tuple[int, int]:
    """The interval, extended by the movements by which the hands leave and reach their rest."""
    while first > 0 and speed[first] > STILL_M_S:
        first -= 1
    while last < len(speed) - 1 and speed[last] > STILL_M_S:
        last += 1
    return first, last


def _movements(speed: FloatArray, first: int, last: int, rate_hz: float) -> Iterator[_Movement]:
    """The movements of an interval, separated at minima of the speed; a movement that is too short is merged with the
    previous one."""
    for start, end in _stretches(speed[first : last + 1] >= STILL_M_S):
        minima = [start, *(m + start for m in argrelmin(speed[first + start : first + end + 1])[0]), end]
        deep = [m for m in minima[1:-1] if speed[first + m] < 0.6 * min(_peaks(speed[first:], minima, m))]
        for one, other in pairwise([start, *deep, end]):
            if (other - one) / rate_hz >= LEAST_MOVEMENT_S:
                yield _Movement(first + one, first + other, float(speed[first + one : first + other].sum() / rate_hz))


def _peaks(speed: FloatArray, minima: Sequence[int], minimum: int) -> tuple[float, float]:
    """The greatest speeds before and after a minimum, up to the neighbouring minima."""
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


UNKNOWN = "UNKNOWN"


def proposed_tracks(units: Iterable[ProposedUnit], others: Iterable[Track] = ()) -> tuple[Track, ...]:
    """The proposed tracks, after the `others`, such as words and tags."""
    found, known = tuple(units), tuple(others)
    words = next((track.spans for track in known if track.name == "words"), ())
    phrases = [phrase for unit in found for phrase in unit.phrases]
    phases = sorted(_phases(found), key=lambda span: span.start_s)
    return (
        *(known or (Track("words", ()),)),
        Track("phases", tuple(phases)),
        Track("phrases", tuple(_phrase_span(phrase, words) for phrase in phrases)),
        Track("units", tuple(_unit_span(unit) for unit in found)),
    )


def _phases(units: Iterable[ProposedUnit]) -> Iterator[TrackSpan]:
    for unit in units:
        for phase in (*(each for phrase in unit.phrases for each in phrase.phases), unit.retraction):
            yield TrackSpan(phase.interval.start_s, phase.interval.end_s, phase.kind.value)


def _phrase_span(phrase: ProposedPhrase, words: tuple[TrackSpan, ...]) -> TrackSpan:
    hand = "2H" if phrase.left and phrase.right else "LH" if phrase.left else "RH"
    main = next(phase.interval for phase in phrase.phases if phase.kind is PhaseKind.STROKE)
    meant = [number for number, word in enumerate(words) if word.start_s <= main.end_s]
    affiliate = {"affiliate": str(meant[-1])} if meant else {}
    span = _around(phase.interval for phase in phrase.phases)
    return TrackSpan(span.start_s, span.end_s, UNKNOWN, {"hand": hand, **affiliate})


def _unit_span(unit: ProposedUnit) -> TrackSpan:
    phases = [phase.interval for phrase in unit.phrases for phase in phrase.phases]
    span = _around([*phases, unit.retraction.interval])
    return TrackSpan(span.start_s, span.end_s, "")


def _around(intervals: Iterable[Interval]) -> Interval:
    found = list(intervals)
    return Interval(min(each.start_s for each in found), max(each.end_s for each in found))
