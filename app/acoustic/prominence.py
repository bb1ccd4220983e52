"""How prominent each word sounds: the chance that a listener hears one of its syllables as stressed.

The paper's stressed ratio (`app.acoustic.stress`) asks for loudness and pitch. Listeners heed length first, and how
the voice moves more than how high it is. Four cues of each syllable are compared with the mean of the utterance's
syllables and weighed by a logistic regression on syllables whose stress listeners had judged
(`python -m training.prominence`, which speaks German; `python -m benchmarks.prominence` holds speakers out and shows
what each cue is worth). Vowel energy and the mean length of the syllable's phones were tried and add nothing to these.

Frame k is centred on k × `FRAME_SHIFT_S`. A word is as prominent as the most prominent of its syllables; of two vowels
the second's syllable begins with the last consonant between them.
"""

import math
from dataclasses import replace
from itertools import pairwise

import numpy as np

from app.model import FRAME_SHIFT_S, FloatArray, Interval, Phone, Word

VOWELS = frozenset(("AA", "AE", "AH", "AO", "AW", "AY", "EH", "ER", "EY", "IH", "IY", "OW", "OY", "UH", "UW"))
PAUSE_S = 0.15
"""A syllable followed by a longer gap, or by the end, is drawn out by that, not by stress."""

WEIGHTS = np.array([3.1, 0.07, 0.26, -2.4])
"""For the cues in their order: per unit of log duration, per semitone of height and of rise, for a pause."""

BIAS = -2.2
SHORTEST_S = 0.02
UNVOICED_HEIGHT = -6.0
"""Semitones from the speaker's median that a syllable without voiced frames counts as high."""


def prominence(words: tuple[Word, ...], f0_hz: FloatArray) -> tuple[Word, ...]:
    """The words; those whose phones are known with their prominence, in [0, 1]."""
    syllables = [(word.index, syllable) for word in words for syllable in _syllables(word.phones)]
    if not syllables:
        return words
    scores = 1 / (1 + np.exp(-(cues(tuple(syllable for _, syllable in syllables), f0_hz) @ WEIGHTS + BIAS)))
    greatest: dict[int, float] = {}
    for (index, _), score in zip(syllables, scores, strict=True):
        greatest[index] = max(greatest.get(index, 0.0), float(score))
    return tuple(replace(word, prominence=greatest.get(word.index)) for word in words)


def cues(syllables: tuple[Interval, ...], f0_hz: FloatArray) -> FloatArray:
    """What is weighed (syllables × 4), each column less its mean.

    Log duration; the highest f0, in semitones; how much f0 rises from the first voiced frame to the last, in semitones,
    more than in the syllables beside; 1 before a pause.
    """
    voiced_hz = f0_hz[f0_hz > 0]
    semitones = 12 * np.log2(np.where(f0_hz > 0, f0_hz, np.nan) / (np.median(voiced_hz) if len(voiced_hz) else 1.0))
    moves = [_height_and_rise(semitones[_frames(syllable)]) for syllable in syllables]
    heights, rises = np.array(moves).T
    durations_s = np.maximum([syllable.duration_s for syllable in syllables], SHORTEST_S)
    measured = np.column_stack([np.log(durations_s), heights, _beyond_neighbours(rises), _before_pauses(syllables)])
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
