"""The mouth of a voice whose words are unknown: the likeliest of the fifteen shapes and how far it is open, from the
spectrum of .025 s, every `SHIFT_S`. Windows do not look ahead, so a shape is sent as soon as its sound is heard.

The spectrum's bands are judged by linear discriminants with one covariance for all shapes (`models/live/mouth.npz`,
made by `training.live.mouth`), their levels beside the loudest lately. Where the words are known, their phones are the
better mouth (`understudy.behavior.speech`).
"""

import io
import zipfile
from dataclasses import dataclass
from pathlib import Path
from typing import Self

import numpy as np

from ..acoustic.signal.spectrum import mel_filters
from ..behavior.speech import LEAST_ARTICULATION
from ..errors import ServiceError
from ..model import SAMPLE_RATE_HZ, FloatArray
from ..model.tables import OPENINGS, SILENCE

SHIFT_S = 0.02
_SHIFT, _WINDOW, _FFT, _BANDS = round(SHIFT_S * SAMPLE_RATE_HZ), round(0.025 * SAMPLE_RATE_HZ), 512, 24
_LOWEST_HZ, _HIGHEST_HZ = 100.0, 7600.0
_HANN = np.hanning(_WINDOW)
_QUIETEST = 1e-9
_FALL_DB = 0.05
"""The decay of the recent maximum, dB a frame."""

_LEAST_LOUD_DB = -45.0
_RANGE_DB = 30.0
"""A level this far below the recent maximum is silence, and opens nothing."""

FEATURES = _BANDS + 1


@dataclass(frozen=True, slots=True)
class MouthShape:
    """The mouth from `at_s` on: a viseme, how much of it is reached, how wide the jaw is open, both in [0, 1]."""

    at_s: float
    viseme: str
    articulation: float
    opening: float


@dataclass(frozen=True, slots=True, eq=False)
class MouthModel:
    """`weights` (features × shapes) and `bias` (shapes) give the logarithm of how likely each of `visemes` is."""

    visemes: tuple[str, ...]
    weights: FloatArray
    bias: FloatArray

    @classmethod
    def load(cls, path: Path) -> Self:
        """Raises ServiceError `model_unreadable`."""
        try:
            with np.load(io.BytesIO(path.read_bytes()), allow_pickle=False) as arrays:
                names = tuple(str(name) for name in arrays["visemes"])
                weights, bias = arrays["weights"].astype(float), arrays["bias"].astype(float)
        except (OSError, KeyError, ValueError, EOFError, zipfile.BadZipFile) as error:
            raise ServiceError("model_unreadable", f"{path} is not a model of the mouth: {error}") from None
        if weights.shape != (FEATURES, len(names)) or bias.shape != (len(names),) or not set(names) <= set(OPENINGS):
            raise ServiceError("model_unreadable", f"{path}: it was trained on other measures; retrain it")
        return cls(names, weights, bias)


class MouthFeatures:
    """Takes samples at `SAMPLE_RATE_HZ` and gives a row (`FEATURES`) each `SHIFT_S`: the bands' levels less their mean,
    and the mean less the loudest lately, in dB."""

    def __init__(self) -> None:
        self._samples: FloatArray = np.empty(0)
        self._loudest_db = _LEAST_LOUD_DB
        self._filters = mel_filters(_FFT, bands=_BANDS, lowest_hz=_LOWEST_HZ, highest_hz=_HIGHEST_HZ)

    def hear(self, samples: FloatArray) -> FloatArray:
        self._samples = np.concatenate([self._samples, samples])
        count = max(0, (len(self._samples) - _WINDOW) // _SHIFT + 1)
        frames = np.lib.stride_tricks.sliding_window_view(self._samples, _WINDOW)[::_SHIFT][:count] if count else ()
        rows = [self._row(frame) for frame in frames]
        self._samples = self._samples[count * _SHIFT :]
        return np.array(rows).reshape(-1, FEATURES)

    def _row(self, frame: FloatArray) -> FloatArray:
        power = np.abs(np.fft.rfft(frame * _HANN, _FFT)) ** 2
        levels_db = 10 * np.log10(self._filters @ power + _QUIETEST)
        level_db = 10 * np.log10(np.mean(frame**2) + _QUIETEST)
        self._loudest_db = max(self._loudest_db - _FALL_DB, level_db, _LEAST_LOUD_DB)
        return np.append(levels_db - levels_db.mean(), level_db - self._loudest_db)


class StreamingMouth:
    """Takes samples at `SAMPLE_RATE_HZ` and gives the changes of the mouth's shape. Memory is bounded."""

    def __init__(self, model: MouthModel) -> None:
        self._model, self._features = model, MouthFeatures()
        self._frames = 0
        self._scores = np.zeros(len(model.visemes))
        self._last = SILENCE

    def hear(self, samples: FloatArray) -> tuple[MouthShape, ...]:
        """The shapes that begin in more samples."""
        shapes = []
        for row in self._features.hear(samples):
            self._scores = (self._scores + row @ self._model.weights + self._model.bias) / 2
            viseme = SILENCE if row[-1] < -_RANGE_DB else self._model.visemes[int(self._scores.argmax())]
            if viseme != self._last:
                shapes.append(self._shape(viseme, loudness_db=float(row[-1])))
            self._last = viseme
            self._frames += 1
        return tuple(shapes)

    def _shape(self, viseme: str, *, loudness_db: float) -> MouthShape:
        loudness = min(max(1 + loudness_db / _RANGE_DB, 0.0), 1.0)
        articulation = LEAST_ARTICULATION + (1 - LEAST_ARTICULATION) * loudness
        opening = OPENINGS[viseme] * articulation
        return MouthShape(self._frames * SHIFT_S, viseme, round(articulation, 3), round(opening, 3))
