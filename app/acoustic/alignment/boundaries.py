"""Refines phone boundaries to where the spectrum changes, as human labellers place them.

The decoder's hidden Markov models place boundaries with an error of about 10 ms, and word edges next to silence 30 ms
too far out. Kernel ridge regression predicts each boundary's correction from features of the surrounding spectrum. Its
kernel is Gaussian without a bias, so that corrections vanish where the signal is unlike the training data.
`training/alignment` trains the model; `models/alignment/` documents its accuracy.

It replaces a second decoder pass at another frame rate (two-rate refinement that snapped to the greatest spectral
change: 72 % of words within 20 ms for twice the decoding time). It is more accurate (docs/measurements/hearing.md), at
a tenth of the time.

Conventions: times are seconds from the start of the audio. Adjacent phones share one boundary; a pause has two.

The features are the surrounding spectrum, phone classes on both sides, and durations. The spectrum is log Mel levels
every `STEP_S` relative to each band's loud frames, so that neither the recording's level nor its equalization matters.
Levels are kept in half precision: half an hour of audio has 360,000 steps.
"""

import zipfile
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cache
from itertools import pairwise
from pathlib import Path
from typing import Self

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view
from numpy.typing import NDArray

from ...errors import ServiceError
from ...model import SAMPLE_RATE_HZ, Audio, FloatArray, Interval, Phone, SingleArray, Word
from ..signal.fourier import rfft
from ..signal.frames import product
from ..signal.spectrum import mel_filters

BOUNDARIES_AT_ONCE = 200
"""Batch size, to limit memory for long audio."""

FARTHEST_MOVE_S = 0.070

Points = NDArray[np.float32]

Levels = NDArray[np.float16]


@dataclass(frozen=True, slots=True)
class Boundary:
    """The end of `left` and start of `right` (None: silence); `time_s` from the start of the audio."""

    time_s: float
    left: str | None
    right: str | None


@dataclass(frozen=True, slots=True, eq=False)
class BoundaryArrays:
    """Boundaries as arrays: their times (n,) and the distances to the previous and next boundary (n, 2) in seconds, and
    the phone classes before and after (n, 2)."""

    times_s: FloatArray
    gaps_s: FloatArray
    kinds: NDArray[np.int8]

    @classmethod
    def of(cls, found: Sequence[Boundary]) -> Self:
        """All boundaries of a recording, in order; before the first and after the last there is a long gap."""
        times_s = np.array([boundary.time_s for boundary in found])
        between_s = np.concatenate([[LONGEST_GAP_S], np.diff(times_s), [LONGEST_GAP_S]])
        kinds = [[_KIND_NUMBERS[boundary.left], _KIND_NUMBERS[boundary.right]] for boundary in found]
        return cls(times_s, np.column_stack([between_s[:-1], between_s[1:]]), np.array(kinds, np.int8))

    @property
    def at_silence(self) -> NDArray[np.bool_]:
        """Whether one of the two sides is silence (n,)."""
        silent: NDArray[np.bool_] = (self.kinds == _KIND_NUMBERS[None]).any(axis=1)
        return silent

    def part(self, first: int, end: int) -> "BoundaryArrays":
        """The boundaries from index `first` to before `end`."""
        return BoundaryArrays(self.times_s[first:end], self.gaps_s[first:end], self.kinds[first:end])

    def shifted(self, by_s: FloatArray) -> "BoundaryArrays":
        """Each boundary later by `by_s`, with its neighbours unchanged."""
        return BoundaryArrays(self.times_s + by_s, self.gaps_s + np.column_stack([by_s, -by_s]), self.kinds)


@dataclass(frozen=True, slots=True, eq=False)
class BoundaryView:
    """The map from boundaries to feature vectors: surrounding levels less `mean` (steps × bands,) times `basis` (steps
    × bands, components), followed by weighted phone classes and log distances."""

    mean: Points
    basis: Points
    kind_weight: float
    gap_weight: float

    def points(self, levels: Levels, places: BoundaryArrays) -> Points:
        """One feature vector per boundary."""
        kinds = (places.kinds[:, :, None] == np.arange(len(_KINDS))).reshape(len(places.kinds), -1)
        gaps = np.log(places.gaps_s.clip(SHORTEST_GAP_S, LONGEST_GAP_S) / TYPICAL_GAP_S)
        spectra = (levels_around(levels, places.times_s) - self.mean) @ self.basis
        return np.hstack([self.kind_weight * kinds, self.gap_weight * gaps, spectra]).astype(np.float32)


@dataclass(frozen=True, slots=True, eq=False)
class BoundaryModel:
    """The trained regression: a correction is the weighted sum of `exp(−|x − support|²)` over the supports;
    immutable."""

    view: BoundaryView
    supports: Points
    weights_s: Points

    @classmethod
    def load(cls, path: Path) -> Self:
        """Load the model. Raises ServiceError `model_unreadable`."""
        try:
            with np.load(path, allow_pickle=False) as arrays:
                names = ("mean", "basis", "supports", "weights_s")
                mean, basis, supports, weights_s = (arrays[name].astype(np.float32) for name in names)
                view = BoundaryView(mean, basis, float(arrays["kind_weight"]), float(arrays["gap_weight"]))
                return cls(view, supports, weights_s)
        except (OSError, KeyError, ValueError, zipfile.BadZipFile) as error:
            raise ServiceError("model_unreadable", f"{path} is not a boundary model: {error}") from None

    def refine(self, audio: Audio, words: tuple[Word, ...]) -> tuple[Word, ...]:
        """The words, all timed and with phones, with every boundary corrected; order and silences are preserved."""
        levels, places = mel_levels(audio.samples), BoundaryArrays.of(boundaries(words))
        moved_s = places.times_s.copy()
        for first in range(0, len(moved_s), BOUNDARIES_AT_ONCE):
            block = places.part(first, first + BOUNDARIES_AT_ONCE)
            wanted_s = kernel(self.view.points(levels, block), self.supports) @ self.weights_s
            moved_s[first : first + BOUNDARIES_AT_ONCE] += np.clip(wanted_s, -FARTHEST_MOVE_S, FARTHEST_MOVE_S)
        return with_boundaries(words, spaced_times(moved_s, audio.duration_s))


def kernel(one: Points, other: Points) -> Points:
    """The Gaussian kernel exp(−|x − y|²) for every x of `one` and y of `other`."""
    similarity: Points = 2 * one @ other.T
    similarity -= np.sum(one**2, axis=1)[:, None]
    similarity -= np.sum(other**2, axis=1)
    return np.exp(np.minimum(similarity, 0.0, out=similarity), out=similarity)


SHORTEST_PAUSE_S = 0.030
"""Phones closer than this share one boundary."""

SHORTEST_PHONE_S = 0.010


def boundaries(words: Sequence[Word]) -> list[Boundary]:
    """All starts and ends of phones, in order; adjacent phones share one."""
    phones = [phone for word in words for phone in word.phones]
    found = [Boundary(phones[0].interval.start_s, None, phones[0].label)]
    for left, right in pairwise(phones):
        if are_adjacent(left, right):
            found.append(Boundary(right.interval.start_s, left.label, right.label))
        else:
            found.append(Boundary(left.interval.end_s, left.label, None))
            found.append(Boundary(right.interval.start_s, None, right.label))
    return [*found, Boundary(phones[-1].interval.end_s, phones[-1].label, None)]


def are_adjacent(left: Phone, right: Phone) -> bool:
    """Whether two phones share a boundary."""
    return right.interval.start_s - left.interval.end_s < SHORTEST_PAUSE_S


def spaced_times(times_s: FloatArray, duration_s: float) -> FloatArray:
    """The times moved to be at least `SHORTEST_PHONE_S` apart, if the audio is long enough, and within it; in
    milliseconds."""
    room_s = min(SHORTEST_PHONE_S, duration_s / len(times_s)) * np.arange(len(times_s))
    ascending = np.maximum.accumulate(np.maximum(times_s, 0.0) - room_s) + room_s
    latest_s = duration_s - room_s[::-1]
    ordered: FloatArray = np.minimum(ascending, latest_s).round(3)
    return ordered


def with_boundaries(words: tuple[Word, ...], times_s: FloatArray) -> tuple[Word, ...]:
    """The words with their phones between `times_s`, the new times of `boundaries(words)`."""
    remaining = iter([float(time_s) for time_s in times_s])
    previous: Phone | None = None
    start_s = end_s = next(remaining)
    made = []
    for word in words:
        phones = []
        for phone in word.phones:
            if previous is not None:
                start_s = end_s if are_adjacent(previous, phone) else next(remaining)
            previous, end_s = phone, next(remaining)
            phones.append(replace(phone, interval=Interval(start_s, end_s)))
        interval = Interval(phones[0].interval.start_s, phones[-1].interval.end_s)
        made.append(replace(word, interval=interval, phones=tuple(phones)))
    return tuple(made)


STEP_S = 0.005
STEP_SAMPLES = round(STEP_S * SAMPLE_RATE_HZ)
WINDOW_SAMPLES = 256
FRAMES_AT_ONCE = 500

BANDS = 16
LOWEST_HZ, HIGHEST_HZ = 60.0, 7600.0
CONTEXT_STEPS = 14
LOUD_SHARE = 0.95

NOISE_AMPLITUDE = 1e-4
"""Relative to the peak: noise that makes digital silence look like a quiet room."""

SHORTEST_GAP_S, TYPICAL_GAP_S, LONGEST_GAP_S = 0.020, 0.060, 0.300
"""Distances between neighbouring boundaries are clamped to this range."""

_KINDS = (
    frozenset({"AA", "AE", "AH", "AO", "AW", "AY", "EH", "ER", "EY", "IH", "IY", "OW", "OY", "UH", "UW"}),
    frozenset({"M", "N", "NG"}),
    frozenset({"L", "R", "W", "Y"}),
    frozenset({"S", "Z", "SH", "ZH", "CH", "JH"}),
    frozenset({"F", "V", "TH", "DH"}),
    frozenset({"HH"}),
    frozenset({"P", "T", "K"}),
    frozenset({"B", "D", "G"}),
    frozenset({None}),
)
"""Vowels, nasals, approximants, sibilants, other fricatives, HH, voiceless and voiced stops, silence."""

_KIND_NUMBERS = {name: number for number, kind in enumerate(_KINDS) for name in kind}

_WINDOW = np.hanning(WINDOW_SAMPLES).astype(np.float32)
_NOISE_POWER = np.float32(NOISE_AMPLITUDE**2 * np.sum(_WINDOW**2))


def levels_around(levels: Levels, times_s: FloatArray) -> Points:
    """The levels from `CONTEXT_STEPS` before to `CONTEXT_STEPS` after each time, with the ends repeated beyond the
    audio; shape (times, steps × bands), step by step."""
    steps = np.round(times_s / STEP_S).astype(int)
    around = np.clip(steps[:, None] + np.arange(-CONTEXT_STEPS, CONTEXT_STEPS + 1), 0, len(levels) - 1)
    return levels[around].reshape(len(times_s), -1).astype(np.float32)


def mel_levels(samples: FloatArray) -> Levels:
    """Log Mel energies every `STEP_S`, relative to each band's loud frames; shape (steps, bands)."""
    peak = max(samples.max(initial=0.0), -samples.min(initial=0.0)) or 1.0
    levels: Levels = np.empty((len(samples) // STEP_SAMPLES + 1, BANDS), np.float16)
    for first in range(0, len(levels), FRAMES_AT_ONCE):
        end = min(first + FRAMES_AT_ONCE, len(levels))
        levels[first:end] = _log_mel(_frames(samples, first, end) / peak)
    loud = int(LOUD_SHARE * (len(levels) - 1))
    levels -= np.array([np.partition(band, loud)[loud] for band in levels.T])
    return levels


def _frames(samples: FloatArray, first: int, end: int) -> FloatArray:
    """The samples around the steps from `first` to before `end`, zero-padded at both ends; shape (steps, window)."""
    start, stop = first * STEP_SAMPLES - WINDOW_SAMPLES // 2, (end - 1) * STEP_SAMPLES + WINDOW_SAMPLES // 2
    piece = samples[max(start, 0) : stop]
    before = max(-start, 0)
    padded = np.pad(piece, (before, stop - start - before - len(piece)))
    return sliding_window_view(padded, WINDOW_SAMPLES)[::STEP_SAMPLES]


def _log_mel(frames: FloatArray) -> SingleArray:
    """Log Mel energies in single precision, at half the cost."""
    power = np.abs(rfft(frames.astype(np.float32, copy=False) * _WINDOW))
    np.square(power, out=power)
    power += _NOISE_POWER
    return np.log(product(power, _filters()))


@cache
def _filters() -> SingleArray:
    """The Mel filters (bins, bands)."""
    filters = mel_filters(WINDOW_SAMPLES, bands=BANDS, lowest_hz=LOWEST_HZ, highest_hz=HIGHEST_HZ)
    return np.ascontiguousarray(filters.T, dtype=np.float32)
