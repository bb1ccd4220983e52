"""Lip sync: the schedule's visemes as mouth, jaw and tongue (paper §3.8, "Lip Syncing").

The jaw opens as far as the schedule says, wider under stress; every other shape is the viseme's own, as far as it is
articulated. Who wins where two visemes want something else is `coarticulation`'s matter. `mouthClose` is reckoned as a
part of the jaw's opening, so that lips that meet do meet, and it is never more than `jawOpen`.

Lips lead the sound by `LEAD_S`: the mouth has its shape when the sound begins, not after. Viewers notice picture behind
sound from 45 ms on, picture before sound only from 125 ms on (ITU-R BT.1359-1), so the lead is on the safe side; more
would part the lips of a P before it is heard.
"""

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np

from app.model import FloatArray, Interval, Viseme
from app.realizer.coarticulation import Segments, blend
from app.realizer.face_tables import INDEX, SILENCE, VISEMES, Articulator, VisemeTable
from app.realizer.motion import SHAPES

LEAD_S = 0.015

_JAW, _CLOSE = INDEX["jawOpen"], INDEX["mouthClose"]
_MARGIN_S = 1.0


@dataclass(frozen=True, slots=True, eq=False)
class Speech:
    """The mouth as speech has it, `shapes` (T, 52), and the part left to expressions: of the mouth's `corners`
    (T,), and of `lips` and jaw (T,), which are free in silence alone."""

    shapes: FloatArray
    corners: FloatArray
    lips: FloatArray


def speak(table: VisemeTable, visemes: tuple[Viseme, ...], times_s: FloatArray) -> Speech:
    """The mouth at `times_s` of the audio; shut where nothing is said."""
    spoken = tuple(_without_gaps(visemes, float(times_s[0]) - _MARGIN_S, float(times_s[-1]) + _MARGIN_S))
    segments = _segments(spoken)
    columns = np.flatnonzero(np.array(table.articulator) >= 0)
    channels = np.array(table.articulator)[columns]
    order = list(Articulator)
    extra = [order.index(Articulator.ROUNDING), order.index(Articulator.LIPS)]
    leaves = np.stack([table.leaves_corners[segments.kind], segments.kind == VISEMES.index(SILENCE)], axis=-1)
    targets = np.concatenate([_targets(table, spoken, segments)[:, columns], leaves], axis=-1)
    mean = blend(table.dominance, segments, targets, np.array([*channels, *extra]), times_s + LEAD_S)
    shapes = np.zeros((len(times_s), len(SHAPES)))
    shapes[:, columns] = mean[:, :-2]
    shapes[:, _CLOSE] = np.minimum(shapes[:, _CLOSE], 1) * shapes[:, _JAW]
    return Speech(shapes, corners=mean[:, -2], lips=mean[:, -1])


def _targets(table: VisemeTable, visemes: tuple[Viseme, ...], segments: Segments) -> FloatArray:
    """(segments, 52): each viseme's own shape."""
    silent = segments.kind == VISEMES.index(SILENCE)
    articulation = np.where(silent, 1.0, [viseme.articulation for viseme in visemes])
    targets = table.targets[segments.kind] * articulation[:, None]
    targets[:, _JAW] = np.array([viseme.opening for viseme in visemes]) * table.widest_jaw
    return np.asarray(targets)


def _segments(visemes: tuple[Viseme, ...]) -> Segments:
    return Segments(
        kind=np.array([VISEMES.index(viseme.label) for viseme in visemes]),
        start_s=np.array([viseme.interval.start_s for viseme in visemes]),
        end_s=np.array([viseme.interval.end_s for viseme in visemes]),
    )


def _without_gaps(visemes: tuple[Viseme, ...], start_s: float, end_s: float) -> Iterator[Viseme]:
    """The visemes with silence wherever there is none, from `start_s` to `end_s`."""
    at_s = start_s
    for viseme in visemes:
        if viseme.interval.start_s > at_s:
            yield _silence(at_s, viseme.interval.start_s)
        if viseme.interval.end_s > at_s:
            yield replace(viseme, interval=Interval(max(at_s, viseme.interval.start_s), viseme.interval.end_s))
            at_s = viseme.interval.end_s
    if end_s > at_s:
        yield _silence(at_s, end_s)


def _silence(start_s: float, end_s: float) -> Viseme:
    return Viseme(SILENCE, Interval(start_s, end_s), articulation=0.0, opening=0.0)
