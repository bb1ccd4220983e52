"""Degrades speech at random: noise, a room, a telephone, an equaliser.

In degraded speech the decoder makes other errors, and the spectrum at a boundary looks different: a model trained on
clean speech alone leaves boundaries there where the decoder has them. Each function takes samples at 16 kHz and returns
as many. `benchmarks/acoustic/degraded_audio.py` has degradations of its own, with other noise and another codec.
"""

import numpy as np
import soxr
from scipy.signal import butter, fftconvolve, sosfilt

from understudy.model import SAMPLE_RATE_HZ, FloatArray

NOISE_DB = (-25.0, -8.0)
"""Against the speech."""

NOISE_TILT = (0.0, 0.9)
"""Power of the frequency by which the noise's amplitudes fall: 0 is white, 0.5 pink."""

DECAY_S = (0.2, 0.8)
"""To −60 dB."""

DIRECT_OVER_REVERBERANT_DB = (0.0, 10.0)
TELEPHONE_RATE_HZ = 8_000
TELEPHONE_LOWEST_HZ, TELEPHONE_HIGHEST_HZ = (200.0, 400.0), (3000.0, 3700.0)
MU = 255
EQUALISED_HZ = (0.0, 300.0, 1000.0, 2500.0, 5000.0, 8000.0)
EQUALISER_DB = 6.0
"""Standard deviation of the gain at each of these."""


def in_noise(samples: FloatArray, chance: np.random.Generator) -> FloatArray:
    """With steady noise of some colour."""
    spectrum = np.fft.rfft(chance.standard_normal(len(samples)))
    colour = np.maximum(np.arange(len(spectrum)), 1) ** -chance.uniform(*NOISE_TILT)
    noise = np.fft.irfft(spectrum * colour, len(samples))
    gain = 10 ** (chance.uniform(*NOISE_DB) / 20) * np.sqrt(np.mean(samples**2) / np.mean(noise**2))
    noisy: FloatArray = samples + gain * noise
    return noisy


def in_a_room(samples: FloatArray, chance: np.random.Generator) -> FloatArray:
    """With a tail of exponentially decaying noise."""
    decay_s = chance.uniform(*DECAY_S)
    times_s = np.arange(round(decay_s * SAMPLE_RATE_HZ)) / SAMPLE_RATE_HZ
    tail = chance.standard_normal(len(times_s)) * 10 ** (-3 * times_s / decay_s)
    tail *= 10 ** (-chance.uniform(*DIRECT_OVER_REVERBERANT_DB) / 20) / np.sqrt(np.sum(tail**2))
    reverberant: FloatArray = samples + fftconvolve(samples, tail)[: len(samples)]
    return reverberant


def by_telephone(samples: FloatArray, chance: np.random.Generator) -> FloatArray:
    """In a narrow band, in 8 bits by the mu-law."""
    band_hz = (chance.uniform(*TELEPHONE_LOWEST_HZ), chance.uniform(*TELEPHONE_HIGHEST_HZ))
    band = sosfilt(butter(4, band_hz, "bandpass", fs=SAMPLE_RATE_HZ, output="sos"), samples)
    narrow = soxr.resample(band, SAMPLE_RATE_HZ, TELEPHONE_RATE_HZ)
    narrow *= 0.5 / np.abs(narrow).max()
    code = np.round(127 * np.sign(narrow) * np.log1p(MU * np.abs(narrow)) / np.log1p(MU)) / 127
    decoded = np.sign(code) * np.expm1(np.abs(code) * np.log1p(MU)) / MU
    widened: FloatArray = soxr.resample(decoded, TELEPHONE_RATE_HZ, SAMPLE_RATE_HZ)[: len(samples)]
    return np.pad(widened, (0, len(samples) - len(widened)))


def equalised(samples: FloatArray, chance: np.random.Generator) -> FloatArray:
    """By another microphone."""
    frequencies_hz = np.fft.rfftfreq(len(samples), 1 / SAMPLE_RATE_HZ)
    gains_db = np.interp(frequencies_hz, EQUALISED_HZ, chance.normal(0.0, EQUALISER_DB, len(EQUALISED_HZ)))
    return np.fft.irfft(np.fft.rfft(samples) * 10 ** (gains_db / 20), len(samples))
