"""Runs of frames, and the frames around them."""

import numpy as np
import pytest

from understudy.realizer.arms.stretches import around, frames_in, stretches


def test_stretches_are_the_runs_of_true_values_at_the_ends_too() -> None:
    inside = np.array([True, False, False, True, True, False, True])
    assert stretches(inside).tolist() == [[0, 1], [3, 5], [6, 7]]
    assert stretches(np.zeros(3, dtype=bool)).tolist() == []


def test_around_has_neighbours_on_both_sides() -> None:
    assert around(np.array([False, False, False, True, False]), 1).tolist() == [False, False, True, True, True]


@pytest.mark.parametrize(("rate_hz", "time_s", "frames"), [(60, 0.1, 6), (30, 0.1, 3), (30, 0.001, 1)])
def test_a_time_has_frames_by_the_rate_and_at_least_one(rate_hz: int, time_s: float, frames: int) -> None:
    assert frames_in(np.arange(90) / rate_hz, time_s) == frames
