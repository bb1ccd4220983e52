"""Voice quality every 10 ms: breathy and lax, or clear and tense.

Frame k is centred on k × `FRAME_SHIFT_S`; the signal is zero-padded at both ends. Spectra use 64 ms Hann frames, long
enough for three periods of a low voice. No measure depends on the recording's level. Single precision shifts the
cepstral peak by up to 0.4 dB in frames with hardly any treble, and its median over an utterance by at most 0.03 of the
spread between recordings.
"""

import numpy as np
import scipy

from ...model import SAMPLE_RATE_HZ, Audio, FloatArray, SingleArray, VoiceQuality
from ..signal.frames import blocks_of_frames
from .peak_slope import peak_slope

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
    power: SingleArray = np.abs(scipy.fft.rfft(frames * _HANN, _FFT))
    np.square(power, out=power)
    power += LEAST_RANGE * np.maximum(power.max(axis=1, keepdims=True), _LEAST_POWER)
    return power


def _harmonicity_db(power: SingleArray, f0_hz: FloatArray) -> FloatArray:
    voiced = f0_hz > 0
    near = np.rint(SAMPLE_RATE_HZ / np.maximum(f0_hz[voiced, None], _LOWEST_F0_HZ)).astype(int) + _LAGS_ASIDE
    autocorrelation = scipy.fft.dct(power[voiced], type=1)
    likeness = np.take_along_axis(autocorrelation, near, axis=1) / autocorrelation[:, :1] / _WINDOW_LIKENESS[near]
    periodic = np.full(len(f0_hz), _LEAST_PERIODIC)
    periodic[voiced] = np.clip(likeness.max(axis=1), _LEAST_PERIODIC, _MOST_PERIODIC)
    decibels: FloatArray = 10 * np.log10(periodic / (1 - periodic))
    return decibels


def _cepstral_peak_db(power: SingleArray) -> FloatArray:
    decibels = np.log10(power[:, ::2])
    decibels *= 10 / (_FFT // 2)
    cepstrum = scipy.fft.dct(decibels, type=1, overwrite_x=True)[:, _SHORTEST_PERIOD : _LONGEST_PERIOD + 1]
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
