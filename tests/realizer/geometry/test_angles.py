"""Pitch, yaw and roll turn as they say, and are found again."""

import numpy as np

from understudy.realizer.geometry.angles import aim, angles, direction, turn
from understudy.realizer.geometry.rotations import about as around
from understudy.realizer.geometry.rotations import multiply, rotate

GENERATOR = np.random.default_rng(5)
PITCH, YAW, ROLL = (GENERATOR.uniform(-1.4, 1.4, 100) for _ in range(3))
AHEAD = np.array([0.0, 0.0, 1.0])
UP = np.array([0.0, 1.0, 0.0])


def test_a_turn_is_roll_then_pitch_then_yaw() -> None:
    about = [around(axis, angle) for axis, angle in (((0, 1, 0), YAW), ((1, 0, 0), PITCH), ((0, 0, 1), ROLL))]
    assert np.allclose(turn(PITCH, YAW, ROLL), multiply(about[0], multiply(about[1], about[2])))


def test_positive_angles_look_down_and_left_and_lower_the_right_side() -> None:
    zero = np.zeros(1)
    assert rotate(turn(zero + 0.2, zero, zero), AHEAD)[0, 1] < 0
    assert rotate(turn(zero, zero + 0.2, zero), AHEAD)[0, 0] > 0
    assert rotate(turn(zero, zero, zero + 0.2), UP)[0, 0] < 0


def test_angles_are_found_again() -> None:
    assert np.allclose(angles(turn(PITCH, YAW, ROLL)), [PITCH, YAW, ROLL])
    assert np.allclose(aim(3 * direction(PITCH, YAW)), [PITCH, YAW])
    assert np.allclose(rotate(turn(PITCH, YAW, ROLL), AHEAD), direction(PITCH, YAW))
