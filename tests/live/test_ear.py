"""Hearing at any rate."""

from itertools import pairwise

import numpy as np
import pytest
import soxr

from tests.acoustic.pitch.test_streaming import LINE
from understudy.live.ear import Ear
from understudy.model import SAMPLE_RATE_HZ, FloatArray


def pitch(samples: FloatArray, rate_hz: int) -> FloatArray:
    ear, chunk = Ear(rate_hz), rate_hz // 25
    parts = [samples[first : first + chunk] for first in range(0, len(samples), chunk)]
    return np.concatenate([ear.contours(ear.resampled(part))[1] for part in parts])


@pytest.mark.parametrize("rate_hz", [8000, 22_050, 44_100, 48_000])
def test_any_rate_will_do(rate_hz: int) -> None:
    """Frames as many as at our own rate, but for those that the resampler keeps back, and the same voice in nearly all
    of them."""
    expected_hz = pitch(LINE, SAMPLE_RATE_HZ)
    f0_hz = pitch(soxr.resample(LINE, SAMPLE_RATE_HZ, rate_hz), rate_hz)
    count = min(len(f0_hz), len(expected_hz))
    assert abs(len(f0_hz) - len(expected_hz)) <= 5
    both = (f0_hz[:count] > 0) & (expected_hz[:count] > 0)
    assert (np.abs(f0_hz[:count][both] / expected_hz[:count][both] - 1) < 0.02).mean() > 0.95


def test_the_phrase_that_goes_on_is_known() -> None:
    ear = Ear(SAMPLE_RATE_HZ)
    _, f0_hz = ear.contours(LINE)
    edges = ear.phrases(f0_hz)
    assert edges[0].begins
    assert all(one.begins is not other.begins for one, other in pairwise(edges))
    assert ear.phrase_began_s == (edges[-1].at_s if edges[-1].begins else None)
