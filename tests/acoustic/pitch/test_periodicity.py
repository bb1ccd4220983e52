"""Levels and periods of signals whose levels and periods are known."""

import numpy as np
import pytest

from understudy.acoustic.pitch.periodicity import (
    WIDEST_ABOVE_QUIET_DB,
    WIDEST_BELOW_LOUD_DB,
    band_levels,
    band_power,
    periods_nearby,
)
from understudy.model import SAMPLE_RATE_HZ, FloatArray


def tone(frequency_hz: float, duration_s: float = 0.5, amplitude: float = 0.5) -> FloatArray:
    times_s = np.arange(round(duration_s * SAMPLE_RATE_HZ)) / SAMPLE_RATE_HZ
    samples: FloatArray = amplitude * np.sin(2 * np.pi * frequency_hz * times_s)
    return samples


@pytest.mark.parametrize("off", [0.85, 0.95, 1.0, 1.1, 1.2])
@pytest.mark.parametrize("f0_hz", [90.0, 131.3, 240.0, 395.0])
def test_a_pitch_that_is_nearly_right_is_mended(f0_hz: float, off: float) -> None:
    samples = sum((tone(k * f0_hz) for k in range(1, 6)), start=np.zeros(8_000))
    frames = 1 + len(samples) // 160
    nearby_hz, correlation = periods_nearby(band_power(samples), np.full(frames, off * f0_hz))
    np.testing.assert_allclose(nearby_hz[4:-4], f0_hz, rtol=0.015)
    assert (correlation[4:-4] > 0.95).all()


def test_a_pitch_too_deep_for_the_window_is_left_alone() -> None:
    samples = tone(70.0)
    given_hz = np.full(1 + len(samples) // 160, 64.0)
    np.testing.assert_allclose(periods_nearby(band_power(samples), given_hz)[0], given_hz, rtol=1e-9)


def test_noise_does_not_repeat_itself() -> None:
    samples = np.random.default_rng(0).normal(0, 0.1, 16_000)
    assert np.median(periods_nearby(band_power(samples), np.full(101, 200.0))[1]) < 0.6


def test_levels_are_those_of_the_band_among_the_frames() -> None:
    samples = np.concatenate([tone(200), tone(200, amplitude=0.05), tone(4000)])
    levels = band_levels(band_power(samples))
    np.testing.assert_allclose(levels.below_loud_db[5:45], 0, atol=0.5)
    np.testing.assert_allclose(levels.below_loud_db[55:95], -20, atol=0.5)
    assert (levels.below_loud_db[105:145] == -WIDEST_BELOW_LOUD_DB).all()
    assert (levels.above_quiet_db[5:45] == WIDEST_ABOVE_QUIET_DB).all()


@pytest.mark.parametrize("gain", [1e-3, 0.1])
def test_levels_do_not_depend_on_the_recording_level(gain: float) -> None:
    samples = np.concatenate([tone(200), tone(200, amplitude=0.1)])
    loud, faint = band_levels(band_power(samples)), band_levels(band_power(gain * samples))
    np.testing.assert_allclose(faint.below_loud_db, loud.below_loud_db, atol=0.01)
