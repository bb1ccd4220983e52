"""The stressed ratio of words: the share of their frames that exceed the utterance's thresholds (paper §3.1.5).

The thresholds are the utterance's 90th percentiles of energy and f0; a frame is stressed if it exceeds either. Frame k
is centred on k × `FRAME_SHIFT_S` and belongs to the word whose interval contains its centre (start inclusive, end
exclusive). The percentile of f0 is over voiced frames only: the 0 of unvoiced frames is not an observation of f0, and
would lower the threshold with every pause. That of energy is over all frames.
"""

import math
from dataclasses import replace

import numpy as np

from ...model import FRAME_SHIFT_S, Contours, FloatArray, StressThresholds, Word

PERCENTILE = 90.0


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
