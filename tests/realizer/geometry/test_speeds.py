"""A greatest speed changes nothing that keeps it, and is never passed."""

import numpy as np
import pytest

from understudy.model import FloatArray
from understudy.realizer.geometry.rotations import (
    angle_between,
    from_pitch_yaw_roll,
    to_pitch_yaw_roll,
    within_speed,
)

FRAME_S = 0.1
FASTEST_RAD_S = 1.0


def turned(*yaws: float) -> FloatArray:
    zeros = np.zeros(len(yaws))
    return from_pitch_yaw_roll(zeros, np.array(yaws), zeros)


def slowed(*yaws: float) -> list[float]:
    return list(to_pitch_yaw_roll(within_speed(turned(*yaws), FRAME_S, FASTEST_RAD_S))[1])


def test_what_keeps_it_is_as_it_was() -> None:
    rotations = turned(0.0, 0.1, 0.05, 0.0)
    assert within_speed(rotations, FRAME_S, FASTEST_RAD_S) is rotations


def test_a_step_becomes_a_way_at_that_speed_and_arrives() -> None:
    assert slowed(0.0, 0.25, 0.25, 0.25, 0.25) == pytest.approx([0.0, 0.1, 0.2, 0.25, 0.25])


def test_a_second_step_after_all_is_well_is_found_too() -> None:
    assert slowed(0.0, 0.2, 0.2, 0.2, 0.2, 0.0, 0.0) == pytest.approx([0.0, 0.1, 0.2, 0.2, 0.2, 0.1, 0.0])


def test_it_is_never_passed() -> None:
    yaws = np.random.default_rng(1).uniform(-1, 1, 50)
    kept = within_speed(turned(*yaws), FRAME_S, FASTEST_RAD_S)
    assert angle_between(kept[1:], kept[:-1]).max() <= FASTEST_RAD_S * FRAME_S + 1e-9


def test_each_step_may_have_its_own() -> None:
    fastest = np.array([0.5, 2.0, 1.0])
    kept = to_pitch_yaw_roll(within_speed(turned(0.0, 0.25, 0.25, 0.25), FRAME_S, fastest))[1]
    assert list(kept) == pytest.approx([0.0, 0.05, 0.25, 0.25])
