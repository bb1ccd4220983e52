"""Lip sync: visemes as shapes of mouth, jaw and tongue (paper §3.8, "Lip Syncing").

The jaw opens by the schedule's opening, wider under stress; all other shapes are the viseme's, scaled by articulation.
Coarticulation blends neighbouring visemes. `mouthClose` is computed as a share of the jaw's opening so that closed lips
really meet, and never exceeds `jawOpen`.

Lips lead the sound by `LEAD_S`, so that the mouth has its shape when the sound begins. Viewers notice a lagging picture
from 45 ms, a leading one only from 125 ms (ITU-R BT.1359-1); a longer lead would open the lips of a P before it is
heard.

Coarticulation is by dominance functions (Cohen & Massaro 1993). Every phone dominates an articulator with a strength
that decays exponentially with the distance in time; the articulator's position is the mean of the phones' targets,
weighted by dominance. So a T, which hardly constrains the lips, is produced with the lips of its neighbouring vowel,
and a P closes them in any context.

Differences from the 1993 paper: the distance is measured from the inner part of a phone instead of its centre, so that
long phones keep their shape; it is smoothed there, so that curves have no corners; and beyond `HORIZON_S` dominance is
exactly zero, so that each moment depends on few phones. Difference from our paper's §3.8, which concatenates hand-made
diphone curves: these are not public, and dominance covers every pair of phones.

The visemes of diphthongs are split in two, so that the mouth glides as in "how" from wide to round. The schedule has
one of fifteen visemes per phone (docs/references.md), which for a diphthong is that of its first vowel. Where phones
are known too, the last part of a diphthong gets the viseme of the vowel it glides to, with the jaw less open and less
articulated, since glides usually undershoot.
"""

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from types import MappingProxyType

import numpy as np
from numpy.typing import NDArray

from ...model import FloatArray, Interval, Phone, Viseme, Word
from ..body.motion import SHAPES
from .face_tables import INDEX, SILENCE, VISEMES, Articulator, Dominance, VisemeTable

LEAD_S = 0.015

WHOLE_PAUSE_S = 0.12
"""Shorter silences get less dominance: nobody closes the mouth for a tenth of a second between two words."""

_JAW, _CLOSE = INDEX["jawOpen"], INDEX["mouthClose"]

_MARGIN_S = 1.0
"""Longer than the horizon of coarticulation."""

_NEAR_ZERO = 1e-9


@dataclass(frozen=True, slots=True, eq=False)
class LipSync:
    """The mouth in speech, `shapes` (T, 52), and the shares left to expressions: of the mouth's `corners` (T,), and of
    `lips` and jaw (T,), which are free only in silence."""

    shapes: FloatArray
    corners: FloatArray
    lips: FloatArray


def lip_sync(table: VisemeTable, visemes: tuple[Viseme, ...], times_s: FloatArray) -> LipSync:
    """The mouth at `times_s` of the audio; closed in silence."""
    spoken, segments = _segmented(visemes, times_s)
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
    return LipSync(shapes, corners=mean[:, -2], lips=mean[:, -1])


def viseme_weights(table: VisemeTable, visemes: tuple[Viseme, ...], times_s: FloatArray) -> FloatArray:
    """Weights (T, 15) of the visemes, for rigs that have them as morph targets: each in [0, 1], their sum at most 1.

    They use a single dominance for the whole mouth, in which each viseme has a minimum strength so that none is
    skipped. Closing visemes are strengthened as in `lip_sync`, at the cost of the others.
    """
    spoken, segments = _segmented(visemes, times_s)
    equal = replace(table.dominance, strength=np.maximum(table.dominance.strength, 1))
    mouth = np.full(len(VISEMES), list(Articulator).index(Articulator.LIPS))
    targets = np.eye(len(VISEMES))[segments.kind] * _articulation(spoken, segments)[:, None]
    return _pressed(blend(equal, segments, targets, mouth, times_s + LEAD_S), table.targets[:, _CLOSE])


def _pressed(shares: FloatArray, closing: FloatArray) -> FloatArray:
    """The shares (T, 15), with those of visemes that press the lips beyond contact increased accordingly, up to a sum
    of 1."""
    grown = shares * np.where(closing > 1, closing, 0)
    grown /= np.maximum(grown.sum(axis=1, keepdims=True), 1)
    others = shares * (closing <= 1)
    left = np.maximum(1 - grown.sum(axis=1, keepdims=True), 0)
    return np.asarray(grown + others * np.minimum(left / np.maximum(others.sum(axis=1, keepdims=True), _NEAR_ZERO), 1))


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


def _articulation(visemes: tuple[Viseme, ...], segments: Segments) -> FloatArray:
    """The articulation of each segment; that of silence is 1."""
    silent = segments.kind == VISEMES.index(SILENCE)
    return np.where(silent, 1.0, [viseme.articulation for viseme in visemes])


def _targets(table: VisemeTable, visemes: tuple[Viseme, ...], segments: Segments) -> FloatArray:
    """The shapes (segments, 52) of each viseme."""
    targets = table.targets[segments.kind] * _articulation(visemes, segments)[:, None]
    targets[:, _JAW] = np.array([viseme.opening for viseme in visemes]) * table.widest_jaw
    return np.asarray(targets)


def _segmented(visemes: tuple[Viseme, ...], times_s: FloatArray) -> tuple[tuple[Viseme, ...], Segments]:
    """The visemes within a second of the frames, without gaps, and the same as arrays."""
    start_s, end_s = float(times_s[0]) - _MARGIN_S, float(times_s[-1]) + _MARGIN_S
    near = (each for each in visemes if each.interval.end_s > start_s and each.interval.start_s < end_s)
    spoken = tuple(_without_gaps(near, start_s, end_s))
    kind = np.array([VISEMES.index(viseme.label) for viseme in spoken])
    bounds_s = np.array([(viseme.interval.start_s, viseme.interval.end_s) for viseme in spoken])
    pause = np.clip((bounds_s[:, 1] - bounds_s[:, 0]) / WHOLE_PAUSE_S, _NEAR_ZERO, 1)
    weight = np.where(kind == VISEMES.index(SILENCE), pause, 1.0)
    return spoken, Segments(kind, bounds_s[:, 0], bounds_s[:, 1], weight)


def _without_gaps(visemes: Iterable[Viseme], start_s: float, end_s: float) -> Iterator[Viseme]:
    """The visemes from `start_s` to `end_s`, with silence in the gaps."""
    at_s = start_s
    for viseme in visemes:
        if viseme.interval.start_s > at_s:
            yield _silence(at_s, viseme.interval.start_s)
        if viseme.interval.end_s > at_s:
            whole = viseme.interval.start_s >= at_s
            yield viseme if whole else replace(viseme, interval=Interval(at_s, viseme.interval.end_s))
            at_s = viseme.interval.end_s
    if end_s > at_s:
        yield _silence(at_s, end_s)


def _silence(start_s: float, end_s: float) -> Viseme:
    return Viseme(SILENCE, Interval(start_s, end_s), articulation=0.0, opening=0.0)


HORIZON_S = 0.45

_SOFTENING_S = 0.004
_FRAMES_AT_ONCE = 96


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
    """The dominance (articulators, T, segments) of the segments in `near` at each time.

    It decays before and after a segment, but nowhere for both reasons: insets are at most half a segment long.
    """
    kind, start_s, end_s = segments.kind[near], segments.start_s[near], segments.end_s[near]
    strength = dominance.strength[kind].T[:, None]
    until_s, since_s = start_s - at_s[:, None], at_s[:, None] - end_s
    away_s = np.maximum(until_s, since_s)
    within = np.maximum(1 - (np.maximum(away_s, 0) / HORIZON_S) ** 2, 0)
    within *= segments.weight[near]
    inset_s = np.minimum(dominance.inset_s[:, None, None], (end_s - start_s) / 2)
    left = _softened(away_s + inset_s)
    before, after = (-1 / each[kind].T[:, None] for each in (dominance.before_s, dominance.after_s))
    left *= np.where(until_s > since_s, before, after)
    np.exp(left, out=left)
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


GLIDES: Mapping[str, str] = MappingProxyType({"AY": "I", "EY": "I", "OY": "I", "AW": "U", "OW": "U"})
"""The viseme that each diphthong glides to."""

GLIDE_SHARE = 0.4
"""The share of the phone that the glide takes."""

GLIDE_ARTICULATION = 0.7
GLIDE_OPENING = 0.7
"""As a factor of the diphthong's own."""


def with_glides(visemes: tuple[Viseme, ...], words: tuple[Word, ...]) -> tuple[Viseme, ...]:
    """The visemes, with the last part of each diphthong as a viseme of its own."""
    gliding = [phone for word in words for phone in word.phones if phone.label in GLIDES]
    return tuple(_split(visemes, gliding)) if gliding else visemes


def _split(visemes: Iterable[Viseme], gliding: list[Phone]) -> Iterator[Viseme]:
    """Split a viseme at each glide within it; several phones of one shape may share a viseme."""
    coming = iter(sorted(gliding, key=lambda phone: phone.interval.end_s))
    phone = next(coming, None)
    for viseme in visemes:
        rest = viseme
        while phone and phone.interval.end_s <= rest.interval.end_s:
            start_s = phone.interval.end_s - GLIDE_SHARE * phone.interval.duration_s
            if rest.interval.start_s < start_s:
                yield replace(rest, interval=Interval(rest.interval.start_s, start_s))
                yield _glide(rest, GLIDES[phone.label], Interval(start_s, phone.interval.end_s))
                rest = replace(rest, interval=Interval(phone.interval.end_s, rest.interval.end_s))
            phone = next(coming, None)
        if rest.interval.duration_s > 0:
            yield rest


def _glide(viseme: Viseme, label: str, interval: Interval) -> Viseme:
    articulation = GLIDE_ARTICULATION * viseme.articulation
    return Viseme(label, interval, articulation, GLIDE_OPENING * viseme.opening)
