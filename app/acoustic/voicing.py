"""Which frames are voiced: four measures of each frame, weighed together, and a price on every change of mind.

SRH alone, the paper's measure (§3.1.3), hears the window of 100 ms it is taken from: voicing begins too early and ends
too late, a faint hum between words counts as a voice, and so do other voices behind the speaker's. Three measures of
the band in which a voice is strongest, in a window of 40 ms, stand beside it. The weights are a logistic regression
(`python -m training.voicing`); `python -m benchmarks.pitch` shows what they are worth against `SRH_ALONE`.

Frame k is centred on k × `FRAME_SHIFT_S`; n samples make `1 + n // 160` frames. Nothing depends on the level of the
recording: energies are compared with the loud and the quiet frames of the same signal.
"""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view
from numpy.typing import NDArray

from app.acoustic.best_path import best_path
from app.model import FRAME_SHIFT_S, SAMPLE_RATE_HZ, FloatArray

LOWEST_HZ, HIGHEST_HZ = 60, 1000
"""The band of a voice's strongest harmonics: rumble lies below it, hiss above."""

LOUD_PERCENTILE, QUIET_PERCENTILE = 95.0, 10.0
WIDEST_BELOW_LOUD_DB = 25.0
WIDEST_ABOVE_QUIET_DB = 20.0
"""Beyond these, more tells nothing more: silence is silent at -25 dB, and a studio is no better than a quiet room."""

_HOP = round(FRAME_SHIFT_S * SAMPLE_RATE_HZ)
_WINDOW = round(0.040 * SAMPLE_RATE_HZ)
_LONGEST_LAG = _WINDOW * 3 // 4
_FFT = 1200
"""At least a window and the longest lag, lest the correlation go round."""

_BLOCK = 256
_HANN = np.hanning(_WINDOW + 1)[:-1]
_WINDOW_CORRELATION = np.fft.irfft(np.abs(np.fft.rfft(_HANN, _FFT)) ** 2, _FFT)[:_WINDOW]
_LEAST_ENERGY = 1e-10


@dataclass(frozen=True, slots=True)
class Voicing:
    """How the four measures are weighed: a frame is voiced when their weighted sum exceeds `threshold`.

    harmonics: weight of the SRH at f0.
    periodicity: weight of the correlation, at most 1, of the band with itself one period later.
    below_loud, above_quiet: weights of the band's energy over the loud and over the quiet frames, per 10 dB.
    change_cost: what it costs to turn from voiced to unvoiced or back between two frames, in units of the sum.
    """

    harmonics: float
    periodicity: float
    below_loud: float
    above_quiet: float
    threshold: float
    change_cost: float

    @property
    def weights(self) -> FloatArray:
        return np.array([self.harmonics, self.periodicity, self.below_loud, self.above_quiet])


SRH_ALONE = Voicing(1.0, 0.0, 0.0, 0.0, threshold=0.07, change_cost=0.0)
"""The published decision (Drugman & Alwan 2011)."""

WEIGHED = Voicing(15.3, 3.8, 2.25, 1.75, threshold=2.95, change_cost=2.0)
"""Fitted by `training.voicing` on the files of odd number; the cost was chosen on the same."""


@dataclass(frozen=True, slots=True, eq=False)
class Levels:
    """The band's energy in each frame: how far under the loud frames (<= 0) and over the quiet ones (>= 0)."""

    below_loud_db: FloatArray
    above_quiet_db: FloatArray


def band_levels(samples: FloatArray) -> Levels:
    """How loud each frame is among those of the signal."""
    energies = [np.sum(_band_spectra(windows), axis=1) for windows in _blocks(samples)]
    level_db = 10 * np.log10(np.concatenate(energies) + _LEAST_ENERGY)
    loud_db, quiet_db = np.percentile(level_db, [LOUD_PERCENTILE, QUIET_PERCENTILE])
    return Levels(
        below_loud_db=np.clip(level_db - loud_db, -WIDEST_BELOW_LOUD_DB, 0),
        above_quiet_db=np.clip(level_db - quiet_db, 0, WIDEST_ABOVE_QUIET_DB),
    )


def periodicity(samples: FloatArray, f0_hz: FloatArray) -> FloatArray:
    """How well the band of each frame correlates with itself a period of `f0_hz` (> 0) later, -1 to 1."""
    lags = np.minimum(np.rint(SAMPLE_RATE_HZ / f0_hz).astype(np.intp), _LONGEST_LAG)
    starts = range(0, len(lags), _BLOCK)
    blocks = zip(_blocks(samples), starts, strict=True)
    return np.concatenate([_correlations(windows, lags[start : start + _BLOCK]) for windows, start in blocks])


def measures(srh: FloatArray, periodicities: FloatArray, levels: Levels) -> FloatArray:
    """What is weighed, in the order of `Voicing.weights` (frames × 4)."""
    return np.column_stack([srh, periodicities, levels.below_loud_db / 10, levels.above_quiet_db / 10])


def voiced_frames(measured: FloatArray, voicing: Voicing) -> NDArray[np.bool_]:
    """Whether each frame is voiced."""
    excess = measured @ voicing.weights - voicing.threshold
    change_costs = np.broadcast_to(voicing.change_cost * (1 - np.eye(2)), (len(excess) - 1, 2, 2))
    voiced: NDArray[np.bool_] = best_path(np.column_stack([np.zeros(len(excess)), excess]), change_costs) == 1
    return voiced


def _blocks(samples: FloatArray) -> Iterator[FloatArray]:
    """The windows of all frames, `_BLOCK` at a time."""
    windows = sliding_window_view(np.pad(samples, _WINDOW // 2), _WINDOW)[::_HOP][: 1 + len(samples) // _HOP]
    for start in range(0, len(windows), _BLOCK):
        yield windows[start : start + _BLOCK]


def _band_spectra(windows: FloatArray) -> FloatArray:
    """Power of each window at each frequency of the FFT, 0 outside the band."""
    frequencies_hz = np.fft.rfftfreq(_FFT, 1 / SAMPLE_RATE_HZ)
    band = (frequencies_hz >= LOWEST_HZ) & (frequencies_hz <= HIGHEST_HZ)
    power: FloatArray = np.abs(np.fft.rfft(windows * _HANN, _FFT)) ** 2 * band
    return power


def _correlations(windows: FloatArray, lags: NDArray[np.intp]) -> FloatArray:
    """Autocorrelation of each window's band at its own lag, over that at lag 0 and freed of the window's own."""
    correlation = np.fft.irfft(_band_spectra(windows), _FFT)
    at_lag = correlation[np.arange(len(windows)), lags] / (correlation[:, 0] + _LEAST_ENERGY)
    freed: FloatArray = np.clip(at_lag * _WINDOW_CORRELATION[0] / _WINDOW_CORRELATION[lags], -1, 1)
    return freed
