"""How prominent each word sounds: the chance that a listener hears one of its syllables as stressed.

The paper's stressed ratio (`understudy.acoustic.stress.stress`) asks for loudness and pitch. Listeners heed length
first, and how the voice moves more than how high it is. Five cues of each syllable are compared with the mean of the
utterance's syllables and weighed by a logistic regression on syllables whose stress listeners had judged (`python -m
training.prominence`, which speaks German; `python -m benchmarks.acoustic.prominence` holds speakers out and shows what
each cue is worth, in German and English). Loudness counts only against the syllables beside; against the whole
utterance it adds nothing to these, nor does the mean length of the syllable's phones.

A flat voice makes smaller differences, yet listeners hear stress in each of its sentences (.16 of the syllables of
neutral, .23 of angry speech). So the weighed sum is divided by the root of its standard deviation in the utterance:
half way between counting differences as they are, which finds none in a tenth of the neutral sentences, and counting
all utterances as equally lively.

Frame k is centred on k × `FRAME_SHIFT_S`. A word is as prominent as the most prominent of its syllables; of two vowels
the second's syllable begins with the last consonant between them.
"""

import math
from dataclasses import replace
from itertools import pairwise

import numpy as np

from ...model import FRAME_SHIFT_S, Contours, FloatArray, Interval, Phone, Word

VOWELS = frozenset(("AA", "AE", "AH", "AO", "AW", "AY", "EH", "ER", "EY", "IH", "IY", "OW", "OY", "UH", "UW"))
PAUSE_S = 0.15
"""A syllable followed by a longer gap, or by the end, is drawn out by that, not by stress."""

WEIGHTS = np.array([5.83, 0.07, 0.74, 0.09, -4.84])
"""For the cues in their order: per unit of log duration, per semitone of height and of rise, per dB, for a pause;
divided by the root of the spread."""

BIAS = -2.24
LEAST_SPREAD = 0.1
"""Less is none: syllables all alike."""

SHORTEST_S = 0.02
UNVOICED_HEIGHT = -6.0
"""Semitones from the speaker's median that a syllable without voiced frames counts as high."""

DEEPEST_FALL = -1.0
"""Semitones. Syllables that stand out rise more often than they fall; but a deep fall is an accent as well ("cold" in
"rather cold hearted"), and tells no more against it than a slight one."""


def prominence(words: tuple[Word, ...], contours: Contours) -> tuple[Word, ...]:
    """The words; those whose phones are known with their prominence, in [0, 1]."""
    syllables = [(word.index, syllable) for word in words for syllable in _syllables(word.phones)]
    if not syllables:
        return words
    scores = 1 / (1 + np.exp(-log_odds(cues(tuple(syllable for _, syllable in syllables), contours))))
    greatest: dict[int, float] = {}
    for (index, _), score in zip(syllables, scores, strict=True):
        greatest[index] = max(greatest.get(index, 0.0), float(score))
    return tuple(replace(word, prominence=greatest.get(word.index)) for word in words)


def log_odds(measured: FloatArray, weights: FloatArray = WEIGHTS, bias: float = BIAS) -> FloatArray:
    """The log odds, for each syllable of an utterance, that listeners hear it as stressed, from its `cues`."""
    sums = measured @ weights
    odds: FloatArray = sums / np.sqrt(max(float(np.std(sums)), LEAST_SPREAD)) + bias
    return odds


def cues(syllables: tuple[Interval, ...], contours: Contours) -> FloatArray:
    """What is weighed (syllables × 5), each column less its mean.

    Log duration; the highest f0, in semitones; how much f0 rises from the first voiced frame to the last, in semitones,
    at least `DEEPEST_FALL`, and the highest energy, in dB, both beyond the syllables beside; 1 before a pause.
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
    """The phones' time cut into syllables; one where there is no vowel, none where there is no phone."""
    nuclei = [place for place, phone in enumerate(phones) if phone.label in VOWELS]
    onsets = [max(nucleus - 1, before + 1) for before, nucleus in pairwise(nuclei)]
    starts = [phones[place].interval.start_s for place in [0, *onsets]] if phones else []
    ends = [*starts[1:], phones[-1].interval.end_s] if phones else []
    return [Interval(start_s, end_s) for start_s, end_s in zip(starts, ends, strict=True)]


def _frames(interval: Interval) -> slice:
    """The frames whose centres lie in the interval; that of its start where there are none."""
    first, end = (math.ceil(round(time_s / FRAME_SHIFT_S, 6)) for time_s in (interval.start_s, interval.end_s))
    return slice(first, max(end, first + 1))


def _height_and_rise(semitones: FloatArray) -> tuple[float, float]:
    """The highest pitch and the last less the first; NaN is unvoiced."""
    voiced = semitones[~np.isnan(semitones)]
    return (float(voiced.max()), float(voiced[-1] - voiced[0])) if len(voiced) else (UNVOICED_HEIGHT, 0.0)


def _highest(contour: FloatArray, frames: slice) -> float:
    """The contour's highest value in these frames; its last where they lie beyond it."""
    return float(contour[frames].max(initial=-np.inf)) if frames.start < len(contour) else float(contour[-1])


def _beyond_neighbours(values: FloatArray) -> FloatArray:
    """Each value less the mean of the two beside it; the first and the last are neighbours of themselves."""
    padded = np.pad(values, 1, mode="edge")
    beyond: FloatArray = values - (padded[:-2] + padded[2:]) / 2
    return beyond


def _before_pauses(syllables: tuple[Interval, ...]) -> FloatArray:
    """1 for a syllable after which none begins for `PAUSE_S`."""
    starts_s = np.array([syllable.start_s for syllable in syllables[1:]] + [np.inf])
    ends_s = np.array([syllable.end_s for syllable in syllables])
    before: FloatArray = (starts_s - ends_s > PAUSE_S).astype(float)
    return before
