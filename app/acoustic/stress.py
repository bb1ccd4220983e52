"""The stress of words: the paper's stressed ratio (§3.1.5), perceived prominence, and their emphasis, from the selected
of the two, the value that all later stages use.

The stressed ratio is the share of a word's frames that exceed the utterance's thresholds, its 90th percentiles of
energy and f0; a frame is stressed if it exceeds either. Frame k is centred on k × `FRAME_SHIFT_S` and belongs to the
word whose interval contains its centre (start inclusive, end exclusive). The percentile of f0 is over voiced frames
only: the 0 of unvoiced frames is not an observation of f0, and would lower the threshold with every pause. That of
energy is over all frames.

Prominence is the probability that listeners perceive one of a word's syllables as stressed. The paper's ratio uses
loudness and pitch. Listeners rely mostly on duration, and on pitch movement more than on pitch height. Five cues of
each syllable, relative to the mean of the utterance's syllables, are weighted by a logistic regression trained on
syllables rated by listeners (`python -m training.prominence`, on German; `python -m benchmarks.acoustic.prominence`
evaluates on held-out speakers, with the contribution of each cue, in German and English). Loudness is relative to the
neighbouring syllables only; relative to the whole utterance it adds nothing, nor does the mean duration of the
syllable's phones. A word is as prominent as its most prominent syllable; between two vowels the second syllable begins
with the last consonant.

In a flat voice the differences are smaller, yet listeners perceive stress in each of its sentences (on .16 of the
syllables in neutral, .23 in angry speech). So the weighted sum is divided by the square root of its standard deviation
in the utterance: a compromise between absolute differences, by which a tenth of neutral sentences have no stress, and
treating all utterances as equally lively.

Of whole words listeners' own judgement is known better: a network that was taught by crowds of them
(`understudy.acoustic.focus.listeners`) hears the ends of phrases and the words before pauses as listeners do, where
length misleads. Where the recording was heard, a word's prominence is a weighted sum of both log odds
(`with_listeners`), by which content words of TIMIT stand over function words more often than by either alone.

Rules test the emphasis, strokes fall on the word with the highest, repeated strokes and head dips on emphasized words,
and the mouth opens by it. Prominence agrees with listeners far better than the paper's ratio
(`benchmarks/acoustic/prominence.py`). Words without known phones have only the ratio and are judged by it. Since their
thresholds differ, both are mapped to one scale, piecewise linearly: 0 to 0, the threshold to `EMPHASISED`, 1 to 1.
"""

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import Literal

import numpy as np

from ..model import EMPHASISED, FRAME_SHIFT_S, Contours, FloatArray, Interval, Phone, StressThresholds, Word

PERCENTILE = 90.0

PROMINENT = 0.34
"""The prominence above which as many syllables lie as listeners perceive as stressed (`training/prominence.py`)."""

STRESSED = 0.1
"""The paper's threshold of the stressed ratio (Figure 8)."""


def stress(words: tuple[Word, ...], contours: Contours) -> tuple[tuple[Word, ...], StressThresholds]:
    """The words, with the stressed ratio in [0, 1] of those that have an interval, and the thresholds.

    A word without frames has the ratio 0.
    """
    voiced_hz = contours.f0_hz[contours.f0_hz > 0]
    thresholds = StressThresholds(
        energy_db=float(np.percentile(contours.energy_db, PERCENTILE)),
        f0_hz=float(np.percentile(voiced_hz, PERCENTILE)) if len(voiced_hz) else None,
    )
    stressed = contours.energy_db > thresholds.energy_db
    if thresholds.f0_hz is not None:
        stressed = stressed | (contours.f0_hz > thresholds.f0_hz)
    return tuple(_with_ratio(word, stressed.astype(float)) for word in words), thresholds


def _with_ratio(word: Word, stressed: FloatArray) -> Word:
    if word.interval is None:
        return word
    first, end = (
        math.ceil(round(time_s / FRAME_SHIFT_S, 6)) for time_s in (word.interval.start_s, word.interval.end_s)
    )
    frames = stressed[max(first, 0) : max(end, 0)]
    return replace(word, stressed_ratio=float(np.mean(frames)) if len(frames) else 0.0)


@dataclass(frozen=True, slots=True)
class Measure:
    """The measure of emphasis, and the value of each measure above which a word is emphasized."""

    name: Literal["prominence", "ratio"] = "prominence"
    above_prominence: float = PROMINENT
    above_ratio: float = STRESSED


def with_emphasis(words: tuple[Word, ...], measure: Measure) -> tuple[Word, ...]:
    """The words; those with a measure get their emphasis, rounded to thousandths."""
    return tuple(replace(word, emphasis=_emphasis(word, measure)) for word in words)


def _emphasis(word: Word, measure: Measure) -> float | None:
    if word.prominence is not None and measure.name == "prominence":
        return _scaled(word.prominence, measure.above_prominence)
    return None if word.stressed_ratio is None else _scaled(word.stressed_ratio, measure.above_ratio)


def _scaled(value: float, threshold: float) -> float:
    if value <= threshold:
        return round(EMPHASISED * value / threshold, 3) if threshold else 0.0
    return round(EMPHASISED + (1 - EMPHASISED) * (value - threshold) / (1 - threshold), 3)


VOWELS = frozenset(("AA", "AE", "AH", "AO", "AW", "AY", "EH", "ER", "EY", "IH", "IY", "OW", "OY", "UH", "UW"))
PAUSE_S = 0.15
"""A syllable before a longer gap, or at the end, is lengthened by it and not by stress."""

WEIGHTS = np.array([5.83, 0.07, 0.74, 0.09, -4.84])
"""The cues in order: per unit of log duration, per semitone of height and of rise, per dB, for a pause; before division
by the root of the spread."""

BIAS = -2.24
LEAST_SPREAD = 0.1
"""The minimum of the spread."""

LISTENERS_WEIGHT, SYLLABLES_WEIGHT, BOTH_BIAS = 1.1, 0.33, 0.4
"""Of the log odds of both: the proportion that serves TIMIT's words best, with as many of them above the threshold of
emphasis as syllables alone put there."""

LEAST_LIKELY = 1e-4
"""Syllables are taken to be no surer than this."""

SHORTEST_S = 0.02
UNVOICED_HEIGHT = -6.0
"""The height assumed for unvoiced syllables, in semitones relative to the speaker's median."""

DEEPEST_FALL = -1.0
"""Semitones. Stressed syllables rise more often than they fall; but a deep fall can be an accent as well ("cold" in
"rather cold hearted"), so it counts no more against stress than a slight one."""


def prominence(words: tuple[Word, ...], contours: Contours) -> tuple[Word, ...]:
    """The words; those with known phones get their prominence in [0, 1]."""
    syllables = [(word.index, syllable) for word in words for syllable in _syllables(word.phones)]
    if not syllables:
        return words
    scores = 1 / (1 + np.exp(-log_odds(cues(tuple(syllable for _, syllable in syllables), contours))))
    greatest: dict[int, float] = {}
    for (index, _), score in zip(syllables, scores, strict=True):
        greatest[index] = max(greatest.get(index, 0.0), float(score))
    return tuple(replace(word, prominence=greatest.get(word.index)) for word in words)


def with_listeners(words: tuple[Word, ...], heard: Mapping[int, float]) -> tuple[Word, ...]:
    """The words; of those that listeners judged (log odds by index) and whose syllables are known, the prominence is
    by both."""
    return tuple(
        replace(word, prominence=_by_both(word.prominence, heard[word.index]))
        if word.prominence is not None and word.index in heard
        else word
        for word in words
    )


def _by_both(syllables: float, listeners: float) -> float:
    likely = min(max(syllables, LEAST_LIKELY), 1 - LEAST_LIKELY)
    odds = LISTENERS_WEIGHT * listeners + SYLLABLES_WEIGHT * math.log(likely / (1 - likely)) + BOTH_BIAS
    return 1 / (1 + math.exp(-odds))


def log_odds(measured: FloatArray, weights: FloatArray = WEIGHTS, bias: float = BIAS) -> FloatArray:
    """The log odds that listeners perceive each syllable of an utterance as stressed, from its `cues`."""
    sums = measured @ weights
    odds: FloatArray = sums / np.sqrt(max(float(np.std(sums)), LEAST_SPREAD)) + bias
    return odds


def cues(syllables: tuple[Interval, ...], contours: Contours) -> FloatArray:
    """The cues (syllables × 5), each column with its mean removed.

    Log duration; the maximum f0 in semitones; the rise of f0 from the first to the last voiced frame in semitones, at
    least `DEEPEST_FALL`, and the maximum energy in dB, both relative to the neighbouring syllables; 1 before a pause.
    """
    voiced_hz = contours.f0_hz[contours.f0_hz > 0]
    middle_hz = np.median(voiced_hz) if len(voiced_hz) else 1.0
    semitones = 12 * np.log2(np.where(contours.f0_hz > 0, contours.f0_hz, np.nan) / middle_hz)
    frames = [_frames(syllable) for syllable in syllables]
    heights, moves = np.array([_height_and_rise(semitones[each]) for each in frames]).T
    levels_db = np.array([_highest(contours.energy_db, each) for each in frames])
    durations_s = np.maximum([syllable.duration_s for syllable in syllables], SHORTEST_S)
    beyond = (_beyond_neighbours(values) for values in (np.maximum(moves, DEEPEST_FALL), levels_db))
    measured = np.column_stack([np.log(durations_s), heights, *beyond, _before_pauses(syllables)])
    centred: FloatArray = measured - measured.mean(axis=0)
    return centred


def _syllables(phones: tuple[Phone, ...]) -> list[Interval]:
    """The phones grouped into syllables; one if there is no vowel, none if there are no phones."""
    nuclei = [place for place, phone in enumerate(phones) if phone.label in VOWELS]
    onsets = [max(nucleus - 1, before + 1) for before, nucleus in pairwise(nuclei)]
    starts = [phones[place].interval.start_s for place in [0, *onsets]] if phones else []
    ends = [*starts[1:], phones[-1].interval.end_s] if phones else []
    return [Interval(start_s, end_s) for start_s, end_s in zip(starts, ends, strict=True)]


def _frames(interval: Interval) -> slice:
    """The frames centred in the interval; if there are none, that of its start."""
    first, end = (math.ceil(round(time_s / FRAME_SHIFT_S, 6)) for time_s in (interval.start_s, interval.end_s))
    return slice(first, max(end, first + 1))


def _height_and_rise(semitones: FloatArray) -> tuple[float, float]:
    """The maximum pitch, and the difference of the last and the first; NaN is unvoiced."""
    voiced = semitones[~np.isnan(semitones)]
    return (float(voiced.max()), float(voiced[-1] - voiced[0])) if len(voiced) else (UNVOICED_HEIGHT, 0.0)


def _highest(contour: FloatArray, frames: slice) -> float:
    """The contour's maximum in these frames; its last value if they lie beyond it."""
    return float(contour[frames].max(initial=-np.inf)) if frames.start < len(contour) else float(contour[-1])


def _beyond_neighbours(values: FloatArray) -> FloatArray:
    """Each value less the mean of its neighbours; at the ends, the value itself replaces the missing neighbour."""
    padded = np.pad(values, 1, mode="edge")
    beyond: FloatArray = values - (padded[:-2] + padded[2:]) / 2
    return beyond


def _before_pauses(syllables: tuple[Interval, ...]) -> FloatArray:
    """1 for syllables that are not followed by another within `PAUSE_S`."""
    starts_s = np.array([syllable.start_s for syllable in syllables[1:]] + [np.inf])
    ends_s = np.array([syllable.end_s for syllable in syllables])
    before: FloatArray = (starts_s - ends_s > PAUSE_S).astype(float)
    return before
