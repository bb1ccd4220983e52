"""Simulates other rooms and microphones for recordings made in quiet studios, so that a model becomes robust to them.

Each recording is changed in its own way, drawn with the given generator.
"""

import numpy as np

from understudy.model import SAMPLE_RATE_HZ, Audio, FloatArray

EQUALISATION_DB = 4.0
"""Deviation of the gain's first cosine over the Mel scale; the k-th of four is fainter by the root of k."""

TELEPHONE_SHARE = 0.3
TELEPHONE_HZ = (300.0, 3400.0)


def degraded(audio: Audio, random: np.random.Generator) -> Audio:
    """Either in noise or through another channel."""
    return in_noise(audio, random) if random.uniform() < 0.5 else through_other_channel(audio, random)


def in_noise(audio: Audio, random: np.random.Generator) -> Audio:
    """In steady noise 12 to 30 dB under the recording's mean power, white, brown or between."""
    return _with_noise(audio, random, decibels=random.uniform(12, 30), tilt=random.uniform(-2, 0.3))


def through_other_channel(audio: Audio, random: np.random.Generator) -> Audio:
    """Through a microphone of another response, at times a telephone, and some faint noise."""
    frequencies_hz = _frequencies_hz(audio)
    gain: FloatArray = 10 ** (_equalisation_db(frequencies_hz, random) / 20)
    if random.uniform() < TELEPHONE_SHARE:
        gain = gain * _telephone_gain(frequencies_hz)
    heard = Audio(np.fft.irfft(np.fft.rfft(audio.samples) * gain, len(audio.samples)))
    return _with_noise(heard, random, decibels=random.uniform(25, 45), tilt=random.uniform(-2, 0))


def in_white_noise(audio: Audio, random: np.random.Generator) -> Audio:
    """In white noise 20 dB under the recording's mean power."""
    return _with_noise(audio, random, decibels=20, tilt=0)


def by_telephone(audio: Audio, _random: np.random.Generator) -> Audio:
    """Through a telephone's band alone."""
    gain = _telephone_gain(_frequencies_hz(audio))
    return Audio(np.fft.irfft(np.fft.rfft(audio.samples) * gain, len(audio.samples)))


def _frequencies_hz(audio: Audio) -> FloatArray:
    """Of the recording's transform."""
    return np.asarray(np.fft.rfftfreq(len(audio.samples), 1 / SAMPLE_RATE_HZ), dtype=np.float64)


def _telephone_gain(frequencies_hz: FloatArray) -> FloatArray:
    """The amplitude that a telephone leaves of each frequency: a Butterworth band of sixth order."""
    low_hz, high_hz = TELEPHONE_HZ
    ratio = np.maximum(frequencies_hz, 1.0)
    gain: FloatArray = 1 / np.sqrt((1 + (low_hz / ratio) ** 12) * (1 + (ratio / high_hz) ** 12))
    return gain


def _equalisation_db(frequencies_hz: FloatArray, random: np.random.Generator) -> FloatArray:
    mel = np.log1p(frequencies_hz / 700) / np.log1p(SAMPLE_RATE_HZ / 2 / 700)
    orders = np.arange(1, 5)[:, None]
    amplitudes = random.normal(0, EQUALISATION_DB, (4, 1)) / np.sqrt(orders)
    gain_db: FloatArray = np.sum(amplitudes * np.cos(np.pi * orders * mel), axis=0)
    return gain_db


def _with_noise(audio: Audio, random: np.random.Generator, *, decibels: float, tilt: float) -> Audio:
    """Noise `decibels` under the recording, whose power goes as frequency to the power of `tilt`."""
    count = len(audio.samples)
    gain = np.maximum(_frequencies_hz(audio), 50.0) ** (tilt / 2)
    noise = np.fft.irfft(np.fft.rfft(random.normal(size=count)) * gain, count)
    power = np.mean(audio.samples**2) * 10 ** (-decibels / 10)
    return Audio(audio.samples + noise * np.sqrt(power / np.mean(noise**2)))
