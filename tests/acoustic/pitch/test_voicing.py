"""The voicing decision on hand-made measures."""

from itertools import product

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from understudy.acoustic.pitch.voicing import (
    SRH_ALONE,
    WEIGHED,
    WIDEST_ABOVE_QUIET_DB,
    WIDEST_BELOW_LOUD_DB,
    Levels,
    Voicing,
    band_levels,
    band_power,
    measures,
    periods_nearby,
    voiced_frames,
)
from understudy.model import SAMPLE_RATE_HZ, FloatArray

CLEAR = (0.25, 0.95, 0.0, 20.0)
HUM = (0.12, 0.9, -25.0, 0.0)
HISS = (0.02, 0.2, -12.0, 8.0)


def measured(*frames: tuple[float, float, float, float]) -> FloatArray:
    srh, periodicity, below_loud_db, above_quiet_db = np.array(frames).T
    return measures(srh, periodicity, Levels(below_loud_db, above_quiet_db))


@pytest.mark.parametrize(("frame", "weighed", "alone"), [(CLEAR, True, True), (HUM, False, True), (HISS, False, False)])
def test_a_hum_between_words_is_no_voice(frame: tuple[float, float, float, float], weighed: bool, alone: bool) -> None:
    assert voiced_frames(measured(*[frame] * 5), WEIGHED).tolist() == [weighed] * 5
    assert voiced_frames(measured(*[frame] * 5), SRH_ALONE).tolist() == [alone] * 5


def test_one_frame_in_doubt_does_not_break_the_voice() -> None:
    doubt = Voicing(1.0, 0.0, 0.0, 0.0, threshold=0.07, change_cost=0.01)
    frames = measured(*[CLEAR] * 4, (0.06, 0, 0, 0), *[CLEAR] * 4)
    assert voiced_frames(frames, doubt).all()
    assert not voiced_frames(frames, SRH_ALONE)[4]


def test_a_single_frame_is_judged() -> None:
    assert voiced_frames(measured(CLEAR), WEIGHED).tolist() == [True]


@given(frames=st.integers(1, 8), seed=st.integers(0, 10_000), cost=st.sampled_from([0.0, 0.3, 1.0, 3.0]))
def test_no_other_decisions_are_worth_more(frames: int, seed: int, cost: float) -> None:
    measured = np.random.default_rng(seed).normal(size=(frames, 4))
    voicing = Voicing(1.0, 0.5, 0.0, 0.0, threshold=0.1, change_cost=cost)
    excess = measured @ voicing.weights - voicing.threshold

    def worth(voiced: tuple[bool, ...]) -> float:
        return float(np.sum(excess[np.array(voiced)]) - cost * np.sum(np.diff(voiced)))

    best = max(worth(voiced) for voiced in product((False, True), repeat=frames))
    assert worth(tuple(voiced_frames(measured, voicing).tolist())) == pytest.approx(best)


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
