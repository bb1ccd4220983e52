"""Prosodic features of speech, one row each `FRAME_S`: the observations of the gesture model (AHG §3.2, eq. 3 to 6).

A frame's window is .05 s: log mean energy, log f0 and the confidence of f0, each with its change since .05 s before.
The features are causal, so a live stream has the same features as its recording.

Departures: confidence is the share of the window that our pitch tracker calls voiced, not YIN's eq. 5, since YIN is not
run; f0 holds its last value in unvoiced frames. Energy and f0 are normalised by a running mean and standard deviation
of the voiced frames so far, because a live stream has no end yet: the mean adapts to the speaker within a few frames,
the deviation starts at a typical value and adapts over `DEVIATION_FRAMES`, and both forget frames older than about
`MEMORY_FRAMES`.

To a frame temporal context is added: the recent past and `LOOKAHEAD_S` of the future. A stroke ends on a stressed
syllable, so most of the evidence for it comes after it has begun (the gain from the look-ahead is measured in
models/prosody_gestures/README.md). Live decoding is delayed by as much.
"""

from collections import deque
from math import ceil, floor, log, log1p, sqrt

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


LOOKAHEAD_S = 0.15
LOOKAHEAD_FRAMES = round(LOOKAHEAD_S / FRAME_S)
MEANS_OVER = (4, 8, 16, 32)
"""Frames over which energy, f0 and confidence are averaged."""

PAUSE_FRAMES = 8
"""A silence this long starts a new phrase."""

WIDTH = 2 * (len(FEATURES) + 3 * len(MEANS_OVER) + 2)


class ProsodyContext:
    """Adds the context to a stream of features."""

    def __init__(self) -> None:
        longest = max(MEANS_OVER)
        self._lately = deque[FloatArray](np.zeros((longest, 3)), maxlen=longest)
        self._since_pause = self._silent = 0
        self._waiting: deque[FloatArray] = deque()

    def push(self, features: FloatArray) -> FloatArray | None:
        """Takes one more frame's features; returns the row (`WIDTH`) of the frame `LOOKAHEAD_FRAMES` ago, if any."""
        self._waiting.append(self._past(features))
        return self._oldest() if len(self._waiting) > LOOKAHEAD_FRAMES else None

    def finish(self) -> list[FloatArray]:
        """The rows of the remaining frames, the last frame being repeated as their look-ahead."""
        rows = []
        while self._waiting:
            rows.append(self._oldest())
        return rows

    def _oldest(self) -> FloatArray:
        return np.concatenate([self._waiting.popleft(), self._waiting[-1] if self._waiting else self._last])

    def _past(self, features: FloatArray) -> FloatArray:
        self._lately.append(features[:3])
        lately = np.cumsum(np.array(self._lately)[::-1], axis=0)
        means = [lately[frames - 1] / frames for frames in MEANS_OVER]
        self._silent = 0 if features[2] > 2 * VOICED - 1 else self._silent + 1
        self._since_pause = 0 if self._silent >= PAUSE_FRAMES else self._since_pause + 1
        self._last = np.concatenate([features, *means, [log1p(self._since_pause), log1p(self._silent)]])
        return self._last


def in_context(features: FloatArray) -> FloatArray:
    """The rows with context (frames × `WIDTH`) of a recording's features (frames × `FEATURES`)."""
    context = ProsodyContext()
    rows = [row for frame in features if (row := context.push(frame)) is not None]
    return np.array([*rows, *context.finish()]).reshape(-1, WIDTH)
