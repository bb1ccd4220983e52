"""Voice quality every 10 ms: breathy and lax, or clear and tense.

Frame k is centred on k × `FRAME_SHIFT_S`; the signal is zero-padded at both ends. Spectra use 64 ms Hann frames, long
enough for three periods of a low voice. No measure depends on the recording's level. Single precision shifts the
cepstral peak by up to 0.4 dB in frames with hardly any treble, and its median over an utterance by at most 0.03 of the
spread between recordings.

Peak slope, a measure of breathy or tense voice, every 10 ms: the slope of wavelet peak amplitudes over octaves.

A tense voice excites high octaves nearly as much as low ones, a breathy one hardly. Source: Kane & Gobl, "Identifying
regions of non-modal phonation using features of the wavelet transform" (Interspeech 2011).

Frame k is centred on k × `FRAME_SHIFT_S`. The signal is filtered in blocks in the frequency domain; each block is a
whole number of frame shifts long, so that maxima per shift need no loop over frames.
"""

from collections.abc import Iterator
from functools import cache

import numpy as np

from ...model import SAMPLE_RATE_HZ, Audio, FloatArray, SingleArray, VoiceQuality
from ..signal.fourier import dct1, irfft, rfft
from ..signal.frames import SHIFT_SAMPLES, blocks_of_frames, frame_count

LEAST_RANGE = 1e-10
"""Power below this, relative to the maximum (-100 dB), is clamped, so that silence has a spectrum too."""

_LEAST_POWER = 1e-20
"""The minimum of the reference maximum, for digital silence."""

_FRAME = round(0.064 * SAMPLE_RATE_HZ)
_FFT = 2 * _FRAME
_HANN = np.hanning(_FRAME + 1)[:-1].astype(np.float32)

_LOWEST_F0_HZ = 90
"""For lower voices, mostly creaky, the autocorrelation one period later is used; the agitation models are trained
so."""

_LAGS_ASIDE = np.arange(-3, 4)
_LEAST_PERIODIC, _MOST_PERIODIC = 1e-3, 1 - 1e-4
_WINDOW_CORRELATION = np.correlate(_HANN, _HANN, "full")[_FRAME - 1 :]
_WINDOW_LIKENESS = _WINDOW_CORRELATION / _WINDOW_CORRELATION[0]
_SHORTEST_PERIOD, _LONGEST_PERIOD = SAMPLE_RATE_HZ // 500, SAMPLE_RATE_HZ // 60
_TILT_BANDS_HZ = ((50, 1000), (1000, 5000))


def voice_quality(audio: Audio, f0_hz: FloatArray) -> VoiceQuality:
    """The measures of `audio` with the pitch `f0_hz` (frames,), 0 where unvoiced."""
    harmonicity_db, cepstral_peak_db, tilt_db = np.empty((3, len(f0_hz)))
    for block, frames in blocks_of_frames(audio.samples, _FRAME, len(f0_hz)):
        power = _power(frames)
        harmonicity_db[block] = _harmonicity_db(power, f0_hz[block])
        cepstral_peak_db[block] = _cepstral_peak_db(power)
        tilt_db[block] = _tilt_db(power)
    return VoiceQuality(harmonicity_db, cepstral_peak_db, tilt_db, peak_slope(audio.samples))


def _power(frames: SingleArray) -> SingleArray:
    """The power spectrum of each frame (frames × frequencies)."""
    power: SingleArray = np.abs(rfft(frames * _HANN, _FFT))
    np.square(power, out=power)
    power += LEAST_RANGE * np.maximum(power.max(axis=1, keepdims=True), _LEAST_POWER)
    return power


def _harmonicity_db(power: SingleArray, f0_hz: FloatArray) -> FloatArray:
    voiced = f0_hz > 0
    near = np.rint(SAMPLE_RATE_HZ / np.maximum(f0_hz[voiced, None], _LOWEST_F0_HZ)).astype(int) + _LAGS_ASIDE
    autocorrelation = dct1(power[voiced])
    likeness = np.take_along_axis(autocorrelation, near, axis=1) / autocorrelation[:, :1] / _WINDOW_LIKENESS[near]
    periodic = np.full(len(f0_hz), _LEAST_PERIODIC)
    periodic[voiced] = np.clip(likeness.max(axis=1), _LEAST_PERIODIC, _MOST_PERIODIC)
    decibels: FloatArray = 10 * np.log10(periodic / (1 - periodic))
    return decibels


def _cepstral_peak_db(power: SingleArray) -> FloatArray:
    decibels = np.log10(power[:, ::2])
    decibels *= 10 / (_FFT // 2)
    cepstrum = dct1(decibels)[:, _SHORTEST_PERIOD : _LONGEST_PERIOD + 1]
    level_db = 20 * np.log10(np.maximum(np.abs(cepstrum), 1e-6))
    centred = np.arange(level_db.shape[1]) - (level_db.shape[1] - 1) / 2
    slope = np.sum(level_db * centred, axis=1) / np.sum(centred**2)
    peak = level_db.argmax(axis=1)
    line = level_db.mean(axis=1) + slope * centred[peak]
    prominence: FloatArray = np.take_along_axis(level_db, peak[:, None], axis=1)[:, 0] - line
    return prominence


def _tilt_db(power: SingleArray) -> FloatArray:
    bins = (np.array(_TILT_BANDS_HZ) * _FFT) // SAMPLE_RATE_HZ
    low, high = (power[:, first:last].sum(axis=1) for first, last in bins)
    decibels: FloatArray = 10 * np.log10(high / low)
    return decibels


LEAST_RANGE_OF_PEAKS = 1e-5
"""Amplitudes below this, relative to the maximum (-100 dB), are clamped, so that silence has a slope too."""

_LEAST_PEAK = 1e-20
"""The minimum of the reference maximum, for digital silence."""

_OCTAVES = 6

_REACH = 5 * 2 ** (_OCTAVES - 1)
"""Half the length in samples of the longest wavelet."""

_PEAK_FFT = 4096

_SHIFTS = (_PEAK_FFT - 2 * _REACH) // SHIFT_SAMPLES
"""Frame shifts per block: odd, so that blocks centred on frames do not share a shift."""

_STRETCH = _SHIFTS * SHIFT_SAMPLES


def peak_slope(samples: FloatArray) -> FloatArray:
    """The slope per octave of log10 of the maximum amplitude of octave bands within 15 ms of each frame: (frames,)."""
    peaks = _near_frames(np.concatenate(list(_greatest(samples))), frame_count(len(samples)))
    floor = LEAST_RANGE_OF_PEAKS * max(float(peaks.max()), _LEAST_PEAK)
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
        spectra = rfft(signals, _PEAK_FFT)
        greatest = np.empty((len(signals) * _SHIFTS, _OCTAVES), dtype=np.float32)
        first = block.start * _STRETCH - _STRETCH // 2
        for octave, response in enumerate(responses):
            band = np.abs(irfft(spectra * response, _PEAK_FFT)[:, _REACH : _REACH + _STRETCH]).ravel()
            band[: max(-first, 0)] = 0  # ignore the filters' ringing outside the signal
            band[max(len(samples) - first, 0) :] = 0
            greatest[:, octave] = band.reshape(-1, SHIFT_SAMPLES).max(axis=1)
        yield greatest


@cache
def _wavelet_responses() -> SingleArray:
    """The frequency responses of the wavelets centred on 8 kHz, 4 kHz … (octaves × frequencies)."""
    time = np.fft.fftfreq(_PEAK_FFT, 1 / _PEAK_FFT)
    half_periods = 2.0 ** np.arange(_OCTAVES)[:, None]
    wavelets = -np.cos(np.pi * time / half_periods) * np.exp(-((time / half_periods) ** 2) / 2)
    wavelets[np.abs(time) > 5 * half_periods] = 0
    responses: SingleArray = rfft(wavelets).real.astype(np.float32)
    return responses
