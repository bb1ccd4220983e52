"""Peak slope: how the strongest swings of a signal rise or fall from octave to octave, one value every 10 ms.

A pressed voice excites the high octaves nearly as much as the low ones, a breathy one hardly. Source: Kane & Gobl,
"Identifying regions of non-modal phonation using features of the wavelet transform" (Interspeech 2011).

Frame k is centred on k × `FRAME_SHIFT_S`. Stretches of the signal are filtered by products of spectra; each is a whole
number of frame shifts long, so that the greatest magnitudes within shifts are found without a loop over frames.
"""

from collections.abc import Iterator

import numpy as np
from scipy import fft

from ...model import FloatArray, SingleArray
from ..signal.frames import SHIFT_SAMPLES, blocks_of_frames, frame_count

LEAST_RANGE = 1e-5
"""Magnitude, relative to the greatest, below which nothing is told apart (100 dB), so that silence has a slope too."""

_LEAST_PEAK = 1e-20
"""Of what counts as the greatest: digital silence."""

_OCTAVES = 6
_REACH = 5 * 2 ** (_OCTAVES - 1)
"""Samples to either side of its centre that the longest wavelet covers."""

_FFT = 4096
_SHIFTS = (_FFT - 2 * _REACH) // SHIFT_SAMPLES
"""How many frame shifts make a stretch: an odd number, lest a shift lie in two stretches centred on frames."""

_STRETCH = _SHIFTS * SHIFT_SAMPLES


def peak_slope(samples: FloatArray) -> FloatArray:
    """Slope, an octave, of the log10 of the greatest magnitude of octave bands within 15 ms of each frame (frames,)."""
    peaks = _near_frames(np.concatenate(list(_greatest(samples))), frame_count(len(samples)))
    floor = LEAST_RANGE * max(float(peaks.max()), _LEAST_PEAK)
    octaves = (_OCTAVES - 1) / 2 - np.arange(_OCTAVES)
    slope: FloatArray = np.sum(np.log10(np.maximum(peaks, floor)) * octaves, axis=1) / np.sum(octaves**2)
    return slope


def _near_frames(greatest: SingleArray, count: int) -> SingleArray:
    """The greatest in the shift around each frame and the ones before and after it.

    The first stretch, as the first frame, is centred on the first sample.
    """
    first = _SHIFTS // 2
    before, around, after = (greatest[first + step : first + step + count] for step in (-1, 0, 1))
    nearby: SingleArray = np.maximum(np.maximum(before, around), after)
    return nearby


def _greatest(samples: FloatArray) -> Iterator[SingleArray]:
    """The greatest magnitude of each band in each shift, block by block (shifts × octaves)."""
    responses = _wavelet_responses()
    stretches = 1 + (frame_count(len(samples)) + _SHIFTS // 2) // _SHIFTS
    blocks = blocks_of_frames(samples, _STRETCH + 2 * _REACH, stretches, shift=_STRETCH)
    for block, signals in blocks:
        spectra = fft.rfft(signals, _FFT)
        greatest = np.empty((len(signals) * _SHIFTS, _OCTAVES), dtype=np.float32)
        first = block.start * _STRETCH - _STRETCH // 2
        for octave, response in enumerate(responses):
            band = np.abs(fft.irfft(spectra * response, _FFT)[:, _REACH : _REACH + _STRETCH]).ravel()
            band[: max(-first, 0)] = 0  # what rings on outside the signal does not count
            band[max(len(samples) - first, 0) :] = 0
            greatest[:, octave] = band.reshape(-1, SHIFT_SAMPLES).max(axis=1)
        yield greatest


def _wavelet_responses() -> SingleArray:
    """What each wavelet, centred on 8 kHz, 4 kHz …, makes of each frequency (octaves × frequencies)."""
    time = fft.fftfreq(_FFT, 1 / _FFT)
    half_periods = 2.0 ** np.arange(_OCTAVES)[:, None]
    wavelets = -np.cos(np.pi * time / half_periods) * np.exp(-((time / half_periods) ** 2) / 2)
    wavelets[np.abs(time) > 5 * half_periods] = 0
    responses: SingleArray = fft.rfft(wavelets).real.astype(np.float32)
    return responses
