"""Pitch, yaw and roll turn as they say, and are found again."""

import numpy as np

from understudy.realizer.geometry.angles import (
    from_pitch_yaw,
    from_pitch_yaw_roll,
    pitch_and_yaw,
    sine_and_cosine,
    to_pitch_yaw_roll,
    unit_vector,
)
from understudy.realizer.geometry.rotations import from_axis_angle, multiply, rotate

GENERATOR = np.random.default_rng(5)
PITCH, YAW, ROLL = (GENERATOR.uniform(-1.4, 1.4, 100) for _ in range(3))
AHEAD = np.array([0.0, 0.0, 1.0])
UP = np.array([0.0, 1.0, 0.0])


def test_a_turn_is_roll_then_pitch_then_yaw() -> None:
    about_y, about_x, about_z = (
        from_axis_angle(axis, angle) for axis, angle in (((0, 1, 0), YAW), ((1, 0, 0), PITCH), ((0, 0, 1), ROLL))
    )
    assert np.allclose(from_pitch_yaw_roll(PITCH, YAW, ROLL), multiply(about_y, multiply(about_x, about_z)))


def test_a_turn_without_roll_is_the_same() -> None:
    assert np.allclose(from_pitch_yaw(PITCH, YAW), from_pitch_yaw_roll(PITCH, YAW, np.zeros(100)), atol=1e-15)


def test_positive_angles_look_down_and_left_and_lower_the_right_side() -> None:
    zero = np.zeros(1)
    assert rotate(from_pitch_yaw_roll(zero + 0.2, zero, zero), AHEAD)[0, 1] < 0
    assert rotate(from_pitch_yaw_roll(zero, zero + 0.2, zero), AHEAD)[0, 0] > 0
    assert rotate(from_pitch_yaw_roll(zero, zero, zero + 0.2), UP)[0, 0] < 0


def test_angles_are_found_again() -> None:
    assert np.allclose(to_pitch_yaw_roll(from_pitch_yaw_roll(PITCH, YAW, ROLL)), [PITCH, YAW, ROLL])
    assert np.allclose(pitch_and_yaw(3 * unit_vector(PITCH, YAW)), [PITCH, YAW])
    assert np.allclose(rotate(from_pitch_yaw_roll(PITCH, YAW, ROLL), AHEAD), unit_vector(PITCH, YAW))


def test_sines_and_cosines_are_those_of_numpy() -> None:
    angles = np.concatenate([np.linspace(-20.0, 20.0, 4001), np.pi * np.arange(-5, 6)]).reshape(-1, 4)
    sine, cosine = sine_and_cosine(angles)
    assert np.abs(sine - np.sin(angles)).max() < 1e-14
    assert np.abs(cosine - np.cos(angles)).max() < 1e-14
