"""How loud the voice's own band is in each frame, and after what time it repeats itself there.

The band holds a voice's strongest harmonics. Its autocorrelation in windows of 40 ms is nearer to the moment than
harmonics summed in a window of 100 ms, but takes twice the period for the period as readily: it can mend an f0 that is
nearly right, not find one (cf. Boersma, "Accurate short-term analysis of the fundamental frequency …", 1993, whose
division by the window's autocorrelation is used).

Frame k is centred on k × `FRAME_SHIFT_S`; n samples make `1 + n // 160` frames.
"""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view

from app.acoustic.peaks import peak_offsets
from app.model import FRAME_SHIFT_S, SAMPLE_RATE_HZ, FloatArray

LOWEST_HZ, HIGHEST_HZ = 60, 1000
"""The band: rumble lies below it, hiss above."""

LOUD_PERCENTILE, QUIET_PERCENTILE = 95.0, 10.0
WIDEST_BELOW_LOUD_DB = 25.0
WIDEST_ABOVE_QUIET_DB = 20.0
"""Beyond these, more tells nothing more: silence is silent at -25 dB, and a studio is no better than a quiet room."""

REACH_OCTAVES = 0.4
OCTAVE_PENALTY = 0.5
"""Correlation that a period one octave off would have to be better by."""

WINDOW_S = 0.040
PERIODS_IN_WINDOW = 3
"""Deeper voices, fewer of whose periods a window holds, are left as they were found (Boersma's limit)."""

_STEP_OCTAVES = 0.02
_STEPS = np.arange(-REACH_OCTAVES, REACH_OCTAVES + _STEP_OCTAVES / 2, _STEP_OCTAVES)
_HOP = round(FRAME_SHIFT_S * SAMPLE_RATE_HZ)
_WINDOW = round(WINDOW_S * SAMPLE_RATE_HZ)
_LONGEST_LAG = _WINDOW * 3 // 4
_FFT = 1200
"""At least a window and the longest lag, lest the correlation go round."""

_BLOCK = 256
_HANN = np.hanning(_WINDOW + 1)[:-1]
_WINDOW_CORRELATION = np.fft.irfft(np.abs(np.fft.rfft(_HANN, _FFT)) ** 2, _FFT)[: _LONGEST_LAG + 2]
_LEAST_ENERGY = 1e-10


@dataclass(frozen=True, slots=True, eq=False)
class Levels:
    """The band's energy in each frame: how far under the loud frames (<= 0) and over the quiet ones (>= 0)."""

    below_loud_db: FloatArray
    above_quiet_db: FloatArray


def band_levels(samples: FloatArray) -> Levels:
    """How loud each frame is among those of the signal."""
    energies = [np.sum(_band_power(windows), axis=1) for windows in _blocks(samples)]
    level_db = 10 * np.log10(np.concatenate(energies) + _LEAST_ENERGY)
    loud_db, quiet_db = np.percentile(level_db, [LOUD_PERCENTILE, QUIET_PERCENTILE])
    return Levels(
        below_loud_db=np.clip(level_db - loud_db, -WIDEST_BELOW_LOUD_DB, 0),
        above_quiet_db=np.clip(level_db - quiet_db, 0, WIDEST_ABOVE_QUIET_DB),
    )


def periods_nearby(samples: FloatArray, f0_hz: FloatArray) -> tuple[FloatArray, FloatArray]:
    """The f0 in Hz near `f0_hz` (> 0) after whose period each frame repeats itself best, and how well, -1 to 1."""
    starts = range(0, len(f0_hz), _BLOCK)
    blocks = zip(_blocks(samples), starts, strict=True)
    mended = [_mended(windows, f0_hz[start : start + _BLOCK]) for windows, start in blocks]
    nearby_hz, correlation = np.concatenate(mended, axis=1)
    return nearby_hz, correlation


def _blocks(samples: FloatArray) -> Iterator[FloatArray]:
    """The windows of all frames, `_BLOCK` at a time."""
    windows = sliding_window_view(np.pad(samples, _WINDOW // 2), _WINDOW)[::_HOP][: 1 + len(samples) // _HOP]
    for start in range(0, len(windows), _BLOCK):
        yield windows[start : start + _BLOCK]


def _band_power(windows: FloatArray) -> FloatArray:
    """Power of each window at each frequency of the FFT, 0 outside the band."""
    frequencies_hz = np.fft.rfftfreq(_FFT, 1 / SAMPLE_RATE_HZ)
    band = (frequencies_hz >= LOWEST_HZ) & (frequencies_hz <= HIGHEST_HZ)
    power: FloatArray = np.abs(np.fft.rfft(windows * _HANN, _FFT)) ** 2 * band
    return power


def _mended(windows: FloatArray, f0_hz: FloatArray) -> FloatArray:
    """The f0 near that of each window and the correlation there (2 × windows)."""
    correlations = _correlations(windows, SAMPLE_RATE_HZ / f0_hz[:, None] * np.exp2(-_STEPS))
    mendable = f0_hz >= PERIODS_IN_WINDOW / WINDOW_S
    merits = np.where(mendable[:, None], correlations, 0.0) - OCTAVE_PENALTY * np.abs(_STEPS)
    best = np.argmax(merits, axis=1)[:, None]
    steps = _STEPS[best] + _STEP_OCTAVES * peak_offsets(merits, best)
    return np.stack([f0_hz * np.exp2(steps[:, 0]), np.take_along_axis(correlations, best, axis=1)[:, 0]])


def _correlations(windows: FloatArray, lags: FloatArray) -> FloatArray:
    """Autocorrelation of each window's band at its own lags, in samples, freed of the window's (windows × lags)."""
    of_signal = np.fft.irfft(_band_power(windows), _FFT)
    freed = of_signal[:, : _LONGEST_LAG + 2] / (of_signal[:, :1] + _LEAST_ENERGY)
    freed *= _WINDOW_CORRELATION[0] / _WINDOW_CORRELATION
    lags = np.minimum(lags, _LONGEST_LAG)
    below = lags.astype(np.intp)
    share = lags - below
    before, after = (np.take_along_axis(freed, below + step, axis=1) for step in (0, 1))
    interpolated: FloatArray = np.clip((1 - share) * before + share * after, -1, 1)
    return interpolated
