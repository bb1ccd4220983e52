"""The stressed ratio of words: the share of their frames that exceed the utterance's thresholds (paper §3.1.5); and
their emphasis, from the selected measure of stress, the value that all later stages use.

The thresholds are the utterance's 90th percentiles of energy and f0; a frame is stressed if it exceeds either. Frame k
is centred on k × `FRAME_SHIFT_S` and belongs to the word whose interval contains its centre (start inclusive, end
exclusive). The percentile of f0 is over voiced frames only: the 0 of unvoiced frames is not an observation of f0, and
would lower the threshold with every pause. That of energy is over all frames.

Rules test the emphasis, strokes fall on the word with the highest, repeated strokes and head dips on emphasized words,
and the mouth opens by it. Prominence (`prominence.py`) agrees with listeners far better than the paper's ratio:
`benchmarks/acoustic/prominence.py`. Words without known phones have only the ratio and are judged by it. Since their
thresholds differ, both are mapped to one scale, piecewise linearly: 0 to 0, the threshold to `EMPHASISED`, 1 to 1.
"""

import math
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from ...model import EMPHASISED, FRAME_SHIFT_S, Contours, FloatArray, StressThresholds, Word

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
