"""Activation, valence and dominance of a voice, estimated frame by frame from the prosody of the last two seconds.

AHG §3.3 uses annotations in [-1, 1] and allows an estimator instead: this is one, linear in eight measures of energy
and f0. Prosody predicts activation well, dominance somewhat and valence hardly (models/prosody_gestures/README.md);
callers with better values pass their own.
"""

import io
import zipfile
from dataclasses import dataclass
from pathlib import Path
from typing import Self

import numpy as np

from ..errors import ServiceError
from ..model import FloatArray
from ..prosody_gestures.prosody import VOICED

DIMENSIONS = ("activation", "valence", "dominance")
WINDOW_FRAMES = 80
MEASURES = (
    "mean of log f0",
    "deviation of log f0",
    "mean change of log f0",
    "deviation of energy",
    "mean change of energy",
    "energy over its mean since the beginning",
    "share of voiced frames",
    "voice onsets a frame",
)


@dataclass(frozen=True, slots=True, eq=False)
class LinearAffectModel:
    """A linear model: `mean` and `scale` (measures) standardise; `weights` (measures × 3), `intercepts` (3) predict."""

    mean: FloatArray
    scale: FloatArray
    weights: FloatArray
    intercepts: FloatArray

    @classmethod
    def load(cls, path: Path) -> Self:
        """Raises ServiceError `model_unreadable`."""
        try:
            with np.load(io.BytesIO(path.read_bytes()), allow_pickle=False) as arrays:
                names = ("mean", "scale", "weights", "intercepts")
                return cls(*(arrays[name].astype(np.float64) for name in names))
        except (OSError, KeyError, ValueError, EOFError, zipfile.BadZipFile) as error:
            raise ServiceError("model_unreadable", f"{path} is not a model of affect: {error}") from None

    def estimate(self, raw: FloatArray) -> FloatArray:
        """The affects (frames × `DIMENSIONS`), in [-1, 1], of raw frames (`prosody.raw_frames`)."""
        estimated = (measures(raw) - self.mean) / self.scale @ self.weights + self.intercepts
        clipped: FloatArray = np.clip(estimated, -1, 1)
        return clipped


def measures(raw: FloatArray) -> FloatArray:
    """`MEASURES` over the last `WINDOW_FRAMES` frames, for each frame (frames × measures); energy and f0 are taken from
    voiced frames only and are 0 before the first."""
    energy, f0_hz, confidence = raw.T
    voiced = (confidence >= VOICED).astype(np.float64)
    log_f0 = np.log(np.where(voiced > 0, np.maximum(f0_hz, 1.0), 1.0))
    both = voiced * np.concatenate([[0.0], voiced[:-1]])
    onsets = voiced - both
    pitch, pitch_deviation = _moments(log_f0, voiced)
    level, level_deviation = _moments(energy, voiced)
    so_far = np.cumsum(energy * voiced) / np.maximum(np.cumsum(voiced), 1)
    return np.stack(
        [
            pitch,
            pitch_deviation,
            _mean(np.abs(np.diff(log_f0, prepend=0.0)), both),
            level_deviation,
            _mean(np.abs(np.diff(energy, prepend=0.0)), both),
            np.where(level == 0, 0.0, level - so_far),
            _mean(voiced, np.ones_like(voiced)),
            _mean(onsets, np.ones_like(voiced)),
        ],
        axis=1,
    )


def _moments(values: FloatArray, weights: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Mean and standard deviation over the window."""
    mean = _mean(values, weights)
    deviation: FloatArray = np.sqrt(np.maximum(_mean(values**2, weights) - mean**2, 0))
    return mean, deviation


def _mean(values: FloatArray, weights: FloatArray) -> FloatArray:
    """The weighted mean over the window ending at each frame; 0 where all weights are 0."""
    sums, totals = (_sums(each) for each in (values * weights, weights))
    mean: FloatArray = sums / np.maximum(totals, 1e-9) * (totals > 1e-6)
    return mean


def _sums(values: FloatArray) -> FloatArray:
    total = np.concatenate([[0.0], np.cumsum(values)])
    ends = np.arange(1, len(total))
    windowed: FloatArray = total[ends] - total[np.maximum(ends - WINDOW_FRAMES, 0)]
    return windowed
