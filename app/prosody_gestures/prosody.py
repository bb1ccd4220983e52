"""Prosodic features of speech, one row each `FRAME_S`: the observations of the gesture model (AHG §3.2, eq. 3 to 6).

A frame's window is .05 s: log mean energy, log f0 and the confidence of f0, each with its change since .05 s before.
The features are causal, so a live stream has the same features as its recording.

Departures: confidence is the share of the window that our pitch tracker calls voiced, not YIN's eq. 5, since YIN is not
run; f0 holds its last value in unvoiced frames. Energy and f0 are normalised by a running mean and standard deviation
of the voiced frames so far, because a live stream has no end yet: the mean adapts to the speaker within a few frames,
the deviation starts at a typical value and adapts over `DEVIATION_FRAMES`, and both forget frames older than about
`MEMORY_FRAMES`.
"""

from math import ceil, floor, log, sqrt

import numpy as np

from ..model import FRAME_SHIFT_S, FloatArray
from .semi_markov import FRAME_S

HALF_WINDOW_S = 0.025
CHANGE_FRAMES = 2
MEMORY_FRAMES = 800.0
MEAN_FRAMES = 4.0
"""The prior of the running mean counts as this many frames."""

DEVIATION_FRAMES = 120.0
TYPICAL_DEVIATIONS = (1.4, 0.20)
"""Standard deviations of log energy and log f0 over voiced frames, measured over TIMIT's training speakers."""

VOICED = 0.5
"""Windows with at least this voiced share update the speaker's mean and deviation."""

SILENT_DB = -100.0
FEATURES = ("energy", "f0", "confidence", "change of energy", "change of f0", "change of confidence")


def raw_frames(energy_db: FloatArray, f0_hz: FloatArray) -> FloatArray:
    """Energy, f0 (0: unvoiced) and voiced share of each window (frames × 3), from contours with one row each
    `FRAME_SHIFT_S`."""
    count = whole_frames(len(f0_hz))
    rows = [raw_frame(energy_db, f0_hz, frame) for frame in range(count)]
    return np.array(rows).reshape(-1, 3)


def whole_frames(contour_frames: int) -> int:
    """The number of whole windows in this many frames of a contour."""
    return max(0, floor(((contour_frames - 1) * FRAME_SHIFT_S - HALF_WINDOW_S) / FRAME_S + 1e-6) + 1)


def raw_frame(energy_db: FloatArray, f0_hz: FloatArray, frame: int, base: int = 0) -> tuple[float, float, float]:
    """The energy, f0 and voiced share of one window; the first row of the contours is frame `base`."""
    centre_s = frame * FRAME_S
    first = max(0, ceil((centre_s - HALF_WINDOW_S) / FRAME_SHIFT_S - 1e-6) - base)
    last = floor((centre_s + HALF_WINDOW_S) / FRAME_SHIFT_S + 1e-6) - base
    levels_db, pitches_hz = energy_db[first : last + 1], f0_hz[first : last + 1]
    voiced = pitches_hz[pitches_hz > 0]
    energy = log(float(np.mean(10 ** (np.maximum(levels_db, SILENT_DB) / 10))))
    f0 = float(np.exp(np.mean(np.log(voiced)))) if len(voiced) else 0.0
    return energy, f0, len(voiced) / len(pitches_hz)


def features(raw: FloatArray) -> FloatArray:
    """The features of a recording (frames × `FEATURES`) from its `raw_frames`."""
    normalizer = ProsodyNormalizer()
    return np.array([normalizer.push(*row) for row in raw.tolist()]).reshape(-1, len(FEATURES))


class ProsodyNormalizer:
    """Computes normalised features from a stream of raw frames."""

    def __init__(self) -> None:
        self._energy = _RunningScale(TYPICAL_DEVIATIONS[0])
        self._f0 = _RunningScale(TYPICAL_DEVIATIONS[1])
        self._held = 0.0
        self._before: list[tuple[float, float, float]] = []

    def push(self, energy: float, f0_hz: float, confidence: float) -> tuple[float, ...]:
        """The features of one more frame."""
        if confidence >= VOICED:
            self._energy.hear(energy)
            self._f0.hear(log(f0_hz))
        if f0_hz > 0:
            self._held = self._f0.scaled(log(f0_hz))
        now = (max(self._energy.scaled(energy), -4.0), self._held, 2 * confidence - 1)
        self._before = [*self._before[-CHANGE_FRAMES:], now]
        return (*now, *(after - before for after, before in zip(now, self._before[0], strict=True)))


class _RunningScale:
    """A running mean and standard deviation with exponential forgetting, starting from a typical prior."""

    def __init__(self, deviation: float) -> None:
        self._weight, self._mean = 0.0, 0.0
        self._spread_weight, self._variance = DEVIATION_FRAMES, deviation**2

    def hear(self, value: float) -> None:
        kept = 1 - 1 / MEMORY_FRAMES
        self._weight = self._weight * kept + 1
        difference = value - self._mean
        self._mean += difference / self._weight
        self._spread_weight = self._spread_weight * kept + 1
        self._variance += (difference * (value - self._mean) - self._variance) / self._spread_weight

    def scaled(self, value: float) -> float:
        """The value in standard deviations from the mean; 0 before the first voiced frame, and shrunk towards 0 while
        few frames have been heard."""
        trust = self._weight / (self._weight + MEAN_FRAMES)
        return trust * (value - self._mean) / sqrt(self._variance)
