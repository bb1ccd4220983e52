"""Puts the boundaries of phones where the spectrum changes: what a human labeller does and a decoder cannot.

The decoder's hidden Markov models place a boundary some 10 ms off, and a word's edge against silence 30 ms too far
out. A kernel ridge regression moves each boundary by what labellers would: it sees the Mel spectrum for 50 ms on both
sides and the kinds of the two sounds that meet. Its kernel is Gaussian without a bias, so that where the signal is
like nothing it was trained on, the decoder's time stands. `training/alignment` makes the model, `models/alignment/`
tells how well it does.

It takes the place of a second pass of the decoder at another frame rate (two-rate refinement with a snap to where the
spectrum changes most, 72 % of words within 20 ms for twice the decoder's time): it brings them further, see
docs/measurements.md, at a tenth of the time.
"""

import zipfile
from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from pathlib import Path
from typing import Self

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view

from app.acoustic.mel import mel_filters
from app.errors import ServiceError
from app.model import SAMPLE_RATE_HZ, Audio, FloatArray, Interval, Phone, Word

STEP_S = 0.005
STEP_SAMPLES = round(STEP_S * SAMPLE_RATE_HZ)
WINDOW_SAMPLES = 256
TRANSFORM_SAMPLES = 512
FRAMES_AT_ONCE = 2000
BOUNDARIES_AT_ONCE = 500
"""So many, lest an hour of speech take gigabytes."""

BANDS = 10
LOWEST_HZ, HIGHEST_HZ = 60.0, 7600.0
CONTEXT_STEPS = 10
NOISE_AMPLITUDE = 1e-4
"""Relative to the peak: digital silence then looks like a quiet room."""

SHORTEST_PAUSE_S = 0.030
"""Two phones nearer than this share one boundary."""

SHORTEST_PHONE_S = 0.010
FARTHEST_MOVE_S = 0.070

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

KIND_COLUMNS = 2 * len(_KINDS)
"""The first columns of a view, see `views`."""

_WINDOW = np.hanning(WINDOW_SAMPLES)
_MEL_FILTERS = mel_filters(TRANSFORM_SAMPLES, bands=BANDS, lowest_hz=LOWEST_HZ, highest_hz=HIGHEST_HZ)


@dataclass(frozen=True, slots=True)
class Boundary:
    """Where `left` ends and `right` begins (None: silence); `time_s` from the start of the audio."""

    time_s: float
    left: str | None
    right: str | None


@dataclass(frozen=True, slots=True, eq=False)
class BoundaryModel:
    """The trained regression: a move is the weighted sum of `exp(−|x − support|²)` over the supports; immutable."""

    supports: FloatArray
    weights_s: FloatArray
    mean: FloatArray
    scale: float
    kind_weight: float

    @classmethod
    def load(cls, path: Path) -> Self:
        """Raises ServiceError `model_unreadable`."""
        try:
            with np.load(path, allow_pickle=False) as arrays:
                supports, weights_s, mean = (arrays[name].astype(float) for name in ("supports", "weights_s", "mean"))
                return cls(supports, weights_s, mean, float(arrays["scale"]), float(arrays["kind_weight"]))
        except (OSError, KeyError, ValueError, zipfile.BadZipFile) as error:
            raise ServiceError("model_unreadable", f"{path} is no boundary model: {error}") from None

    def refine(self, audio: Audio, words: tuple[Word, ...]) -> tuple[Word, ...]:
        """`words`, all of them in time and with phones, with every boundary moved; order and silences are kept."""
        found = boundaries(words)
        seen = scaled(views(audio, found), mean=self.mean, scale=self.scale, kind_weight=self.kind_weight)
        blocks = [seen[first : first + BOUNDARIES_AT_ONCE] for first in range(0, len(seen), BOUNDARIES_AT_ONCE)]
        wanted_s = np.concatenate([kernel(block, self.supports) @ self.weights_s for block in blocks])
        moves_s = np.clip(wanted_s, -FARTHEST_MOVE_S, FARTHEST_MOVE_S)
        moved_s = _in_order(np.array([boundary.time_s for boundary in found]) + moves_s, audio.duration_s)
        return _rebuilt(words, moved_s)


def boundaries(words: Sequence[Word]) -> list[Boundary]:
    """Every place where a phone begins or ends, in order; phones that touch share one."""
    phones = [phone for word in words for phone in word.phones]
    found = [Boundary(phones[0].interval.start_s, None, phones[0].label)]
    for left, right in pairwise(phones):
        if touch(left, right):
            found.append(Boundary(right.interval.start_s, left.label, right.label))
        else:
            found.append(Boundary(left.interval.end_s, left.label, None))
            found.append(Boundary(right.interval.start_s, None, right.label))
    return [*found, Boundary(phones[-1].interval.end_s, phones[-1].label, None)]


def touch(left: Phone, right: Phone) -> bool:
    """Whether two phones share a boundary."""
    return right.interval.start_s - left.interval.end_s < SHORTEST_PAUSE_S


def views(audio: Audio, found: Sequence[Boundary]) -> FloatArray:
    """What the regression sees of each boundary: the kinds of both sounds (0 or 1 each), then log Mel levels, step by
    step; shape (boundaries, 18 + 21 × 10)."""
    levels = _mel_levels(audio.samples)
    steps = np.array([round(boundary.time_s / STEP_S) for boundary in found])
    around = np.clip(steps[:, None] + np.arange(-CONTEXT_STEPS, CONTEXT_STEPS + 1), 0, len(levels) - 1)
    kinds = np.array([[name in kind for name in (each.left, each.right) for kind in _KINDS] for each in found], float)
    return np.hstack([kinds, levels[around].reshape(len(found), -1)])


def scaled(seen: FloatArray, *, mean: FloatArray, scale: float, kind_weight: float) -> FloatArray:
    """Views as the kernel compares them: levels centred by `mean`, as a whole weighing as much as the kinds may."""
    return np.hstack([seen[:, :KIND_COLUMNS] * kind_weight, (seen[:, KIND_COLUMNS:] - mean) * scale])


def kernel(one: FloatArray, other: FloatArray) -> FloatArray:
    """exp(−|x − y|²) for every x of `one` and y of `other`."""
    distances = (one**2).sum(axis=1)[:, None] + (other**2).sum(axis=1) - 2 * one @ other.T
    similarity: FloatArray = np.exp(-np.maximum(distances, 0.0))
    return similarity


def _mel_levels(samples: FloatArray) -> FloatArray:
    """Log Mel energies every `STEP_S`, relative to each band's loud frames (95th percentile); shape (steps, bands)."""
    peak = max(samples.max(initial=0.0), -samples.min(initial=0.0)) or 1.0
    count = len(samples) // STEP_SAMPLES + 1
    firsts = range(0, count, FRAMES_AT_ONCE)
    blocks = [_frames(samples, first, min(first + FRAMES_AT_ONCE, count)) for first in firsts]
    levels = np.vstack([_log_mel(block / peak) for block in blocks])
    return levels - np.percentile(levels, 95, axis=0)


def _frames(samples: FloatArray, first: int, end: int) -> FloatArray:
    """The samples around the steps from `first` to before `end`, zeros beyond both ends; shape (steps, window)."""
    start, stop = first * STEP_SAMPLES - WINDOW_SAMPLES // 2, (end - 1) * STEP_SAMPLES + WINDOW_SAMPLES // 2
    piece = samples[max(start, 0) : stop]
    before = max(-start, 0)
    padded = np.pad(piece, (before, stop - start - before - len(piece)))
    return sliding_window_view(padded, WINDOW_SAMPLES)[::STEP_SAMPLES]


def _log_mel(frames: FloatArray) -> FloatArray:
    power = np.abs(np.fft.rfft(frames * _WINDOW, TRANSFORM_SAMPLES)) ** 2
    levels: FloatArray = np.log((power + NOISE_AMPLITUDE**2 * np.sum(_WINDOW**2)) @ _MEL_FILTERS.T)
    return levels


def _in_order(times_s: FloatArray, duration_s: float) -> FloatArray:
    """Times at least `SHORTEST_PHONE_S` apart where the audio is long enough, and all within it; to the millisecond."""
    room_s = min(SHORTEST_PHONE_S, duration_s / len(times_s)) * np.arange(len(times_s))
    ascending = np.maximum.accumulate(np.maximum(times_s, 0.0) - room_s) + room_s
    latest_s = duration_s - room_s[::-1]
    ordered: FloatArray = np.minimum(ascending, latest_s).round(3)
    return ordered


def _rebuilt(words: tuple[Word, ...], times_s: FloatArray) -> tuple[Word, ...]:
    """The words with their phones between `times_s`, which are those of `boundaries(words)`."""
    remaining = iter([float(time_s) for time_s in times_s])
    previous: Phone | None = None
    start_s = end_s = next(remaining)
    rebuilt = []
    for word in words:
        phones = []
        for phone in word.phones:
            if previous is not None:
                start_s = end_s if touch(previous, phone) else next(remaining)
            previous, end_s = phone, next(remaining)
            phones.append(replace(phone, interval=Interval(start_s, end_s)))
        interval = Interval(phones[0].interval.start_s, phones[-1].interval.end_s)
        rebuilt.append(replace(word, interval=interval, phones=tuple(phones)))
    return tuple(rebuilt)
