"""Slopes against convolution with the wavelets themselves."""

import numpy as np
import pytest

from understudy.acoustic.agitation.peak_slope import LEAST_RANGE, peak_slope
from understudy.model import FloatArray

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
