"""Peak slope, a measure of breathy or tense voice, every 10 ms: the slope of wavelet peak amplitudes over octaves.

A tense voice excites high octaves nearly as much as low ones, a breathy one hardly. Source: Kane & Gobl, "Identifying
regions of non-modal phonation using features of the wavelet transform" (Interspeech 2011).

Frame k is centred on k × `FRAME_SHIFT_S`. The signal is filtered in blocks in the frequency domain; each block is a
whole number of frame shifts long, so that maxima per shift need no loop over frames.
"""

from collections.abc import Iterator

import numpy as np
import scipy

from ...model import FloatArray, SingleArray
from ..signal.frames import SHIFT_SAMPLES, blocks_of_frames, frame_count

LEAST_RANGE = 1e-5
"""Amplitudes below this, relative to the maximum (-100 dB), are clamped, so that silence has a slope too."""

_LEAST_PEAK = 1e-20
"""The minimum of the reference maximum, for digital silence."""

_OCTAVES = 6
_REACH = 5 * 2 ** (_OCTAVES - 1)
"""Half the length in samples of the longest wavelet."""

_FFT = 4096
_SHIFTS = (_FFT - 2 * _REACH) // SHIFT_SAMPLES
"""Frame shifts per block: odd, so that blocks centred on frames do not share a shift."""

_STRETCH = _SHIFTS * SHIFT_SAMPLES


def peak_slope(samples: FloatArray) -> FloatArray:
    """The slope per octave of log10 of the maximum amplitude of octave bands within 15 ms of each frame: (frames,)."""
    peaks = _near_frames(np.concatenate(list(_greatest(samples))), frame_count(len(samples)))
    floor = LEAST_RANGE * max(float(peaks.max()), _LEAST_PEAK)
    octaves = (_OCTAVES - 1) / 2 - np.arange(_OCTAVES)
    slope: FloatArray = np.sum(np.log10(np.maximum(peaks, floor)) * octaves, axis=1) / np.sum(octaves**2)
    return slope


def _near_frames(greatest: SingleArray, count: int) -> SingleArray:
    """The maximum over the shift around each frame and its two neighbours.

    The first block, like the first frame, is centred on the first sample.
    """
    first = _SHIFTS // 2
    before, around, after = (greatest[first + step : first + step + count] for step in (-1, 0, 1))
    nearby: SingleArray = np.maximum(np.maximum(before, around), after)
    return nearby


def _greatest(samples: FloatArray) -> Iterator[SingleArray]:
    """The maximum amplitude of each band in each shift, block by block (shifts × octaves)."""
    responses = _wavelet_responses()
    stretches = 1 + (frame_count(len(samples)) + _SHIFTS // 2) // _SHIFTS
    blocks = blocks_of_frames(samples, _STRETCH + 2 * _REACH, stretches, shift=_STRETCH)
    for block, signals in blocks:
        spectra = scipy.fft.rfft(signals, _FFT)
        greatest = np.empty((len(signals) * _SHIFTS, _OCTAVES), dtype=np.float32)
        first = block.start * _STRETCH - _STRETCH // 2
        for octave, response in enumerate(responses):
            band = np.abs(scipy.fft.irfft(spectra * response, _FFT)[:, _REACH : _REACH + _STRETCH]).ravel()
            band[: max(-first, 0)] = 0  # ignore the filters' ringing outside the signal
            band[max(len(samples) - first, 0) :] = 0
            greatest[:, octave] = band.reshape(-1, SHIFT_SAMPLES).max(axis=1)
        yield greatest


def _wavelet_responses() -> SingleArray:
    """The frequency responses of the wavelets centred on 8 kHz, 4 kHz … (octaves × frequencies)."""
    time = scipy.fft.fftfreq(_FFT, 1 / _FFT)
    half_periods = 2.0 ** np.arange(_OCTAVES)[:, None]
    wavelets = -np.cos(np.pi * time / half_periods) * np.exp(-((time / half_periods) ** 2) / 2)
    wavelets[np.abs(time) > 5 * half_periods] = 0
    responses: SingleArray = scipy.fft.rfft(wavelets).real.astype(np.float32)
    return responses
