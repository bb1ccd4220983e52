"""How a voice sounds apart from its pitch and its vowels, one value every 10 ms: breathy and lax, or clear and pressed.

Frame k is centred on k × `FRAME_SHIFT_S`, as all contours are; the signal counts as silent outside itself. Spectra are
of 64 ms Hann frames, long enough for three periods of a low voice. No measure depends on the recording's level.
"""

from dataclasses import dataclass

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view

from app.model import FRAME_SHIFT_S, SAMPLE_RATE_HZ, Audio, FloatArray

LEAST_RANGE = 1e-10
"""Power, relative to the loudest, below which nothing is told apart (100 dB), so that silence has a spectrum too."""

_HOP = round(FRAME_SHIFT_S * SAMPLE_RATE_HZ)
_FRAME = round(0.064 * SAMPLE_RATE_HZ)
_FFT = 2 * _FRAME
_BLOCK = 128
_HANN = np.hanning(_FRAME + 1)[:-1]
_LONGEST_LAG = SAMPLE_RATE_HZ // 45
_LAGS_ASIDE = np.arange(-3, 4)
_QUEFRENCIES = np.arange(SAMPLE_RATE_HZ // 500, SAMPLE_RATE_HZ // 60 + 1)
_TILT_BANDS_HZ = ((50, 1000), (1000, 5000))
_OCTAVES = 6


@dataclass(frozen=True, slots=True, eq=False)
class VoiceQuality:
    """Frame-wise measures, shape (frames,) each; the first means something where the frame is voiced only.

    harmonicity_db: power of the periodic part over that of the rest (Boersma 1993), from the autocorrelation at the
        period, which is taken off the window's own.
    cepstral_peak_db: how far the cepstrum's peak between 60 and 500 Hz stands out of the line through it (Hillenbrand,
        Cleveland & Erickson 1994).
    tilt_db: power from 1 to 5 kHz over power from 50 Hz to 1 kHz.
    peak_slope: slope of the log10 of the greatest amplitude in octave bands, from 250 Hz up to 8 kHz, an octave (Kane &
        Gobl 2011, "Identifying regions of non-modal phonation using features of the wavelet transform").
    """

    harmonicity_db: FloatArray
    cepstral_peak_db: FloatArray
    tilt_db: FloatArray
    peak_slope: FloatArray


def voice_quality(audio: Audio, f0_hz: FloatArray) -> VoiceQuality:
    """The measures of `audio`, whose pitch is `f0_hz` (frames,), 0 where unvoiced."""
    count = len(f0_hz)
    frames = sliding_window_view(np.pad(audio.samples, _FRAME // 2), _FRAME)[::_HOP][:count]
    blocks = [
        _spectral(frames[start : start + _BLOCK], f0_hz[start : start + _BLOCK]) for start in range(0, count, _BLOCK)
    ]
    harmonicity_db, cepstral_peak_db, tilt_db = np.concatenate(blocks, axis=1)
    return VoiceQuality(harmonicity_db, cepstral_peak_db, tilt_db, _peak_slope(audio.samples, count))


def _spectral(frames: FloatArray, f0_hz: FloatArray) -> FloatArray:
    """Harmonicity, cepstral peak and tilt of a block of frames; shape (3, frames)."""
    power = np.abs(np.fft.rfft(frames * _HANN, _FFT)) ** 2
    power += LEAST_RANGE * np.maximum(power.max(axis=1, keepdims=True), np.finfo(float).tiny)
    return np.stack([_harmonicity_db(power, f0_hz), _cepstral_peak_db(power), _tilt_db(power)])


def _harmonicity_db(power: FloatArray, f0_hz: FloatArray) -> FloatArray:
    autocorrelation = np.fft.irfft(power)[:, :_LONGEST_LAG]
    likeness = autocorrelation / autocorrelation[:, :1] / _window_autocorrelation()
    period = np.rint(SAMPLE_RATE_HZ / np.maximum(f0_hz, 2 * SAMPLE_RATE_HZ / _LONGEST_LAG)).astype(int)
    near = np.clip(period[:, None] + _LAGS_ASIDE, 0, _LONGEST_LAG - 1)
    periodic = np.clip(np.take_along_axis(likeness, near, axis=1).max(axis=1), 1e-3, 1 - 1e-4)
    decibels: FloatArray = 10 * np.log10(periodic / (1 - periodic))
    return decibels


def _window_autocorrelation() -> FloatArray:
    correlation = np.fft.irfft(np.abs(np.fft.rfft(_HANN, _FFT)) ** 2)[:_LONGEST_LAG]
    share: FloatArray = correlation / correlation[0]
    return share


def _cepstral_peak_db(power: FloatArray) -> FloatArray:
    cepstrum = np.abs(np.fft.irfft(10 * np.log10(power[:, ::2])))[:, _QUEFRENCIES]
    level_db = 20 * np.log10(np.maximum(cepstrum, 1e-6))
    centred = _QUEFRENCIES - _QUEFRENCIES.mean()
    slope = level_db @ centred / (centred @ centred)
    peak = level_db.argmax(axis=1)
    line = level_db.mean(axis=1) + slope * centred[peak]
    prominence: FloatArray = np.take_along_axis(level_db, peak[:, None], axis=1)[:, 0] - line
    return prominence


def _tilt_db(power: FloatArray) -> FloatArray:
    bins = (np.array(_TILT_BANDS_HZ) * _FFT) // SAMPLE_RATE_HZ
    low, high = (power[:, first:last].sum(axis=1) for first, last in bins)
    decibels: FloatArray = 10 * np.log10(high / low)
    return decibels


def _peak_slope(samples: FloatArray, count: int) -> FloatArray:
    peaks = np.stack([_greatest(band, count) for band in _octave_bands(samples)], axis=1)
    floor = np.sqrt(LEAST_RANGE) * max(float(peaks.max()), np.finfo(float).tiny)
    octaves = (_OCTAVES - 1) / 2 - np.arange(_OCTAVES)
    slope: FloatArray = np.log10(np.maximum(peaks, floor)) @ octaves / (octaves @ octaves)
    return slope


def _octave_bands(samples: FloatArray) -> list[FloatArray]:
    """The signal through Kane & Gobl's wavelets: centred on 8 kHz, then an octave lower each."""
    reach = 5 * 2 ** (_OCTAVES - 1)
    size = 1 << (len(samples) + 2 * reach - 1).bit_length()
    spectrum = np.fft.rfft(samples, size)
    bands = []
    for octave in range(_OCTAVES):
        half_period = 2**octave
        time = np.arange(-5 * half_period, 5 * half_period + 1)
        wavelet = -np.cos(np.pi * time / half_period) * np.exp(-((time / half_period) ** 2) / 2)
        filtered = np.fft.irfft(spectrum * np.fft.rfft(wavelet, size), size)
        bands.append(filtered[5 * half_period : 5 * half_period + len(samples)])
    return bands


def _greatest(signal: FloatArray, count: int) -> FloatArray:
    """The greatest magnitude within 15 ms of each frame's centre."""
    padded = np.zeros((count + 2) * _HOP)
    padded[3 * _HOP // 2 : 3 * _HOP // 2 + len(signal)] = np.abs(signal)
    hops = padded.reshape(-1, _HOP).max(axis=1)
    greatest: FloatArray = np.maximum(np.maximum(hops[:-2], hops[1:-1]), hops[2:])
    return greatest
