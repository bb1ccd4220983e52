"""Measures wrist movement as shared/motion.md does for people: positions low-passed at 6 Hz, then differentiated.

Positions are (T, 3) in metres at an even rate. Speeds are m/s, accelerations m/s², jerks m/s³; the first and last tenth
of a second, where the filter has its edges, do not count.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy.signal import butter, sosfiltfilt

from understudy.model import FloatArray

LOW_PASS_HZ = 6.0
EDGE_S = 0.1
SPEED_BINS_M_S = np.concatenate([np.arange(0, 2.0, 0.1), [2.0, 2.5, 3.0, 100.0]])


@dataclass(frozen=True, slots=True, eq=False)
class WristMeasures:
    """Every frame's speed, acceleration and jerk, of one wrist or of many."""

    speed_m_s: FloatArray
    acceleration_m_s2: FloatArray
    jerk_m_s3: FloatArray


def measured(positions_m: FloatArray, rate_hz: float, *, edge_s: float = EDGE_S) -> WristMeasures:
    """Of one wrist's path without `edge_s` at either end; empty when it is shorter than half a second."""
    edge = round(edge_s * rate_hz)
    if len(positions_m) < 5 * round(EDGE_S * rate_hz):
        return WristMeasures(*(np.empty(0),) * 3)
    smooth = sosfiltfilt(butter(2, LOW_PASS_HZ, fs=rate_hz, output="sos"), positions_m, axis=0)
    lengths = []
    derived = smooth
    for _order in range(3):
        derived = np.gradient(derived, 1 / rate_hz, axis=0)
        lengths.append(np.linalg.norm(derived, axis=-1)[edge : len(derived) - edge])
    return WristMeasures(*lengths)


def together(measures: Sequence[WristMeasures]) -> WristMeasures:
    """Of many wrists."""
    return WristMeasures(
        np.concatenate([each.speed_m_s for each in measures]),
        np.concatenate([each.acceleration_m_s2 for each in measures]),
        np.concatenate([each.jerk_m_s3 for each in measures]),
    )


def hellinger(one_m_s: FloatArray, other_m_s: FloatArray) -> float:
    """The Hellinger distance of two speed histograms, in [0, 1]."""
    histograms = [np.histogram(speeds, SPEED_BINS_M_S)[0] / len(speeds) for speeds in (one_m_s, other_m_s)]
    return float(np.sqrt(max(0.0, 1 - np.sum(np.sqrt(histograms[0] * histograms[1])))))
