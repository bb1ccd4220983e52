"""Movements start and end at rest, reach their ends in time, and never jump."""

import numpy as np
import pytest
import scipy.ndimage

from understudy.realizer.geometry.curves import (
    clipped,
    means_around,
    minimum_jerk,
    minimum_jerk_through,
    plateau,
    reach_of,
    smoothed,
    soft_maximum,
    superposed_movements,
)

TIMES_S = np.arange(0, 4001) / 1000


def test_minimum_jerk_goes_from_0_to_1_and_starts_and_ends_at_rest() -> None:
    course = minimum_jerk(np.linspace(-0.5, 1.5, 2001))
    assert course[[0, 500, 1000, 1500, -1]] == pytest.approx([0, 0, 0.5, 1, 1])
    assert np.all(np.diff(course) >= 0)
    assert np.abs(np.diff(course, 2)).max() < 1e-4
    assert np.diff(course).max() == pytest.approx(1.875 / 1000, rel=1e-3)


def test_movements_that_overlap_add_up_without_a_step_in_speed() -> None:
    by = np.array([[1.0, 2.0], [-1.0, 1.0]])
    course = superposed_movements(TIMES_S, np.array([0.5, 0.8]), np.array([1.0, 0.5]), by)
    assert course[[0, -1]] == pytest.approx(np.array([[0, 0], [0, 3]]))
    assert np.abs(np.diff(course, 2, axis=0)).max() < 1e-4


def test_a_course_rests_in_each_of_its_values() -> None:
    at_s, values = np.array([0.5, 1.0, 3.0]), np.array([2.0, -1.0, 0.5])
    course = minimum_jerk_through(TIMES_S, at_s, values)
    assert course[[0, 500, 1000, 3000, 4000]] == pytest.approx([2, 2, -1, 0.5, 0.5])
    assert np.array_equal(minimum_jerk_through(TIMES_S, at_s[:1], values[:1]), np.full(4001, 2.0))


@pytest.mark.parametrize("reached_s", [1.0, 0.5])
def test_a_plateau_is_held_between_and_zero_outside(reached_s: float) -> None:
    course = plateau(TIMES_S, 0.5, reached_s, 2.0, 2.0)
    assert course[[0, 500, 1001, 2000, 2002]] == pytest.approx([0, 0, 1, 1, 0])


@pytest.mark.parametrize("shape", [(200, 3), (200, 19, 4), (5, 1), (2, 19, 4)])
@pytest.mark.parametrize("width", [0.9, 1.8, 13.2])
def test_curves_are_smoothed_as_by_scipy(shape: tuple[int, ...], width: float) -> None:
    curves = np.random.default_rng(0).normal(size=shape)
    expected = scipy.ndimage.gaussian_filter1d(curves, width, axis=0, mode="nearest")
    assert np.abs(smoothed(curves, width) - expected).max() < 1e-12


@pytest.mark.parametrize("width", [0.9, 1.8])
@pytest.mark.parametrize("frames", [1, 32, 100])
def test_curves_whose_neighbours_are_known_are_smoothed_as_within_longer_ones(frames: int, width: float) -> None:
    reach = reach_of(width)
    curves = np.random.default_rng(0).normal(size=(7, frames + 2 * reach))
    expected = smoothed(curves.T, width)[reach : reach + frames].T
    assert np.abs(means_around(curves, width) - expected).max() < 1e-12


def test_what_is_clipped_is_as_by_numpy() -> None:
    values, lowest = np.linspace(-2, 2, 41)[:, None], np.array([-1.0, 0.0, 1.5])
    assert np.array_equal(clipped(values, lowest, 1.7), np.clip(values, lowest, 1.7))


@pytest.mark.parametrize("softness", [0.0025, 0.5])
def test_a_soft_maximum_is_that_of_numpy(softness: float) -> None:
    one, other = np.random.default_rng(1).normal(size=(2, 200))
    assert soft_maximum(one, other, softness) == pytest.approx(
        softness * np.logaddexp(one / softness, other / softness)
    )
    assert soft_maximum(one, one, softness) == pytest.approx(one + softness * np.log(2.0))
