"""Voice quality of synthetic voices whose harmonicity, tilt and slope are known by construction."""

import numpy as np
import pytest

from understudy.acoustic.agitation.voice_quality import LEAST_RANGE, peak_slope, voice_quality
from understudy.model import SAMPLE_RATE_HZ, Audio, FloatArray, VoiceQuality

F0_HZ = 125.0
TIME_S = np.arange(SAMPLE_RATE_HZ) / SAMPLE_RATE_HZ


def harmonics(slope: float) -> FloatArray:
    """A second of harmonics of `F0_HZ` up to 6 kHz, amplitudes falling as number ** -slope."""
    numbers = np.arange(1, 49)
    voice: FloatArray = np.sin(2 * np.pi * F0_HZ * numbers * TIME_S[:, None]) @ numbers**-slope
    return voice


def measured(samples: FloatArray, f0_hz: float = F0_HZ) -> VoiceQuality:
    return voice_quality(Audio(samples), np.full(1 + len(samples) // 160, f0_hz))


def inner(values: FloatArray) -> float:
    """The median away from the edges, where frames reach into silence."""
    return float(np.median(values[10:-10]))


@pytest.mark.parametrize("ratio_db", [0, 10, 20])
def test_harmonicity_is_the_ratio_of_voice_to_noise(ratio_db: float) -> None:
    voice = harmonics(1.0)
    noise = np.random.default_rng(0).normal(0, voice.std() * 10 ** (-ratio_db / 20), len(voice))
    assert inner(measured(voice + noise).harmonicity_db) == pytest.approx(ratio_db, abs=1.5)


def test_the_cepstral_peak_stands_out_of_a_clear_voice_and_not_of_noise() -> None:
    noise = np.random.default_rng(0).normal(0, 1, SAMPLE_RATE_HZ)
    breathy = harmonics(1.0) + noise
    peaks = [inner(measured(samples).cepstral_peak_db) for samples in (harmonics(1.0), breathy, noise)]
    assert peaks[0] > peaks[1] + 3 > peaks[2] + 3


def test_tilt_is_the_ratio_of_the_bands() -> None:
    low, high = (np.sin(2 * np.pi * frequency_hz * TIME_S) for frequency_hz in (500, 2000))
    assert inner(measured(low + 0.1 * high).tilt_db) == pytest.approx(-20, abs=0.2)


def test_steeper_spectra_have_steeper_peak_slopes() -> None:
    slopes = [inner(measured(harmonics(slope)).peak_slope) for slope in (0.5, 1.0, 2.0)]
    assert slopes == sorted(slopes, reverse=True)


def test_level_changes_nothing() -> None:
    voice = harmonics(1.0) + np.random.default_rng(0).normal(0, 0.1, SAMPLE_RATE_HZ)
    loud, quiet = measured(voice), measured(voice * 1e-3)
    for name in VoiceQuality.__slots__:
        assert getattr(loud, name) == pytest.approx(getattr(quiet, name), abs=0.05)  # decibels, of the cepstral peak


@pytest.mark.parametrize("count", [1, 159, 160, 20_480, 20_481])
def test_every_frame_has_every_measure(count: int) -> None:
    quality = measured(np.random.default_rng(0).normal(0, 0.1, count), f0_hz=0.0)
    for name in VoiceQuality.__slots__:
        assert getattr(quality, name).shape == (1 + count // 160,)
        assert np.all(np.isfinite(getattr(quality, name)))


def test_silence_is_measured_without_infinity() -> None:
    quality = measured(np.zeros(1600), f0_hz=0.0)
    assert all(np.all(np.isfinite(getattr(quality, name))) for name in VoiceQuality.__slots__)


OCTAVES_UP = np.array([2.5, 1.5, 0.5, -0.5, -1.5, -2.5])


def noise(count: int) -> FloatArray:
    swell = 1.1 + np.sin(2 * np.pi * 3 * np.arange(count) / 16_000)
    return swell * np.random.default_rng(count).normal(0, 0.1, count)


def convolved_slope(samples: FloatArray) -> FloatArray:
    """What `peak_slope` should find, by convolution, frame by frame."""
    peaks = []
    for half_period in 2.0 ** np.arange(6):
        time = np.arange(-5 * half_period, 5 * half_period + 1) / half_period
        wavelet = -np.cos(np.pi * time) * np.exp(-(time**2) / 2)
        band = np.convolve(samples, wavelet)[int(5 * half_period) :][: len(samples)]
        padded = np.pad(np.abs(band), 240)
        peaks.append([padded[160 * frame : 160 * frame + 480].max() for frame in range(1 + len(samples) // 160)])
    slopes: FloatArray = OCTAVES_UP @ np.log10(np.maximum(peaks, LEAST_RANGE * np.max(peaks))) / (OCTAVES_UP**2).sum()
    return slopes


@pytest.mark.parametrize("count", [1, 159, 160, 3_680, 5_600, 40_000, 250_000])
def test_slopes_are_those_of_convolution(count: int) -> None:
    assert peak_slope(noise(count)) == pytest.approx(convolved_slope(noise(count)), abs=1e-4)


def test_a_click_shows_the_wavelets_themselves() -> None:
    click = np.zeros(16_000)
    click[8_000] = 0.5
    assert peak_slope(click)[50] == pytest.approx(0, abs=1e-6)  # each of them is 1 in its middle


def test_silence_has_a_slope() -> None:
    assert peak_slope(np.zeros(8_000)).tolist() == [0.0] * 51
