"""What tells which word of a line is stressed against the others: cues of each word, relative to the line's.

A narrow focus raises and widens the pitch of its word, makes it longer, louder and clearer, and compresses what follows
(Cooper, Eady & Mueller 1985; Xu & Xu 2005); speakers may also pause beside it. All cues are differences from the line's
median or from what comes before and after, so neither the speaker's voice nor the level of the recording matters.
Where the phones of a word are not known, the usual length of its letters stands for that of its phones.
"""

from collections.abc import Mapping
from itertools import pairwise

import numpy as np

from ...model import FRAME_SHIFT_S, Contours, FloatArray, Interval, SingleArray, Word
from ..signal.frames import percentiles

CUES = (
    "length", "longest phone", "pitch", "highest pitch", "range of pitch", "move of pitch", "level", "loudest", "tilt",
    "pitch over before", "pitch over after", "level over before", "level over after", "pause before", "pause after",
    "phones", "first", "last",
)  # fmt: skip
"""One column each, in order."""

LETTER_S = 0.065
"""How long a letter usually takes where the phones are not known."""

SHORTEST_S = 0.02
NUCLEUS_DB = 9.0
"""Frames within this of a word's loudest are taken for its vowels."""

FURTHEST_SEMITONES = 12.0
"""Pitches further from the speaker's median are taken for errors of an octave and brought this near."""

LONGEST_PAUSE_S = 0.5
SPLIT_BAND = 15
"""The Mel band, near 1 kHz, from which on energy counts as high: effort tilts the spectrum towards it."""

SCALES = np.array([0.4, 0.6, 3, 3, 3, 4, 6, 6, 6, 3, 3, 6, 6, 0.2, 0.2, 3, 1, 1])
"""Typical sizes of the cues, by which they are divided."""


def cues(words: tuple[Word, ...], contours: Contours, usual_s: Mapping[str, float]) -> FloatArray:
    """The cues (words × `CUES`) of words, all of which have an interval; `usual_s`: seconds of phones by label."""
    semitones = _semitones(contours.f0_hz)
    lengths = np.array([_length(word, usual_s) for word in words])
    sounds = np.array([_sound(_frames(_interval(word), contours), semitones, contours) for word in words])
    count = np.array([[float(len(word.phones) or len(word.text))] for word in words])
    own = np.column_stack([lengths, sounds])
    own = own - np.median(own, axis=0)
    course = np.column_stack([_over_before(sounds), _over_after(sounds)])[:, [0, 2, 1, 3]]
    ends = np.zeros((len(words), 2))
    ends[0, 0] = ends[-1, 1] = 1.0
    measured: FloatArray = np.column_stack([own, course, _pauses(words), count, ends]) / SCALES
    limited: FloatArray = np.clip(measured, -4.0, 4.0)
    return limited


def _interval(word: Word) -> Interval:
    return word.interval or Interval(0.0, 0.0)


def _semitones(f0_hz: FloatArray) -> FloatArray:
    """The pitch over the speaker's median, drawn on through what is unvoiced; 0 if all is."""
    voiced = np.flatnonzero(f0_hz > 0)
    if not len(voiced):
        return np.zeros(len(f0_hz))
    over = 12 * np.log2(f0_hz[voiced] / np.median(f0_hz[voiced]))
    near = np.clip(over, -FURTHEST_SEMITONES, FURTHEST_SEMITONES)
    drawn_on: FloatArray = np.interp(np.arange(len(f0_hz)), voiced, near)
    return drawn_on


def _frames(interval: Interval, contours: Contours) -> slice:
    """The frames in the interval, at least one."""
    last = len(contours.energy_db) - 1
    first = min(round(interval.start_s / FRAME_SHIFT_S), last)
    return slice(first, max(min(round(interval.end_s / FRAME_SHIFT_S), last + 1), first + 1))


def _length(word: Word, usual_s: Mapping[str, float]) -> tuple[float, float]:
    """By how much the word, and its most drawn-out phone, are longer than usual: natural logarithms."""
    usual = sum(usual_s.get(phone.label, LETTER_S) for phone in word.phones) or LETTER_S * len(word.text)
    whole = _longer(_interval(word).duration_s, usual)
    phones = [_longer(phone.interval.duration_s, usual_s.get(phone.label, LETTER_S)) for phone in word.phones]
    return whole, max(phones, default=whole)


def _longer(duration_s: float, usual_s: float) -> float:
    return float(np.log(max(duration_s, SHORTEST_S) / max(usual_s, SHORTEST_S)))


def _sound(frames: slice, semitones: FloatArray, contours: Contours) -> list[float]:
    """Pitch, its height, range and move in semitones; level, its highest, and tilt in dB, of a word's vowels."""
    energy, pitch, bands = contours.energy_db[frames], semitones[frames], contours.mel_db[frames]
    nucleus = energy >= energy.max() - NUCLEUS_DB
    low, high = percentiles(pitch, 10, 90)
    third = max(len(pitch) // 3, 1)
    return [
        float(pitch[nucleus].mean()),
        high,
        high - low,
        float(pitch[-third:].mean() - pitch[:third].mean()),
        float(energy[nucleus].mean()),
        float(energy.max()),
        _tilt(bands[nucleus]),
    ]


def _tilt(bands: SingleArray) -> float:
    """How much the upper bands are over the lower, in dB; 0 where the spectrum is not known, as in live streams."""
    return float(bands[:, SPLIT_BAND:].mean() - bands[:, :SPLIT_BAND].mean()) if bands.shape[1] else 0.0


def _over_before(sounds: FloatArray) -> FloatArray:
    """Highest pitch and level of each word over the mean of all before it; 0 for the first."""
    return _over_earlier(sounds[:, [1, 4]])


def _over_after(sounds: FloatArray) -> FloatArray:
    """The same over all after it; 0 for the last."""
    return _over_earlier(sounds[::-1, [1, 4]])[::-1]


def _over_earlier(values: FloatArray) -> FloatArray:
    earlier = np.cumsum(values, axis=0)[:-1] / np.arange(1, len(values))[:, None]
    over: FloatArray = np.concatenate([np.zeros((1, values.shape[1])), values[1:] - earlier])
    return over


def _pauses(words: tuple[Word, ...]) -> FloatArray:
    """Seconds of silence before and after each word, none at the ends of the line."""
    gaps = [max(_interval(after).start_s - _interval(before).end_s, 0.0) for before, after in pairwise(words)]
    limited = np.minimum(gaps, LONGEST_PAUSE_S)
    return np.column_stack([np.concatenate([[0.0], limited]), np.concatenate([limited, [0.0]])])
