"""Our quaternions against scipy's rotations."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from understudy.model import FloatArray
from understudy.realizer.geometry import rotations
from understudy.realizer.geometry.rotations import (
    from_axis_angle,
    from_pitch_yaw,
    from_pitch_yaw_roll,
    multiply,
    pitch_and_yaw,
    rotate,
    sine_and_cosine,
    to_pitch_yaw_roll,
    unit_vector,
)

A = Rotation.random(50, random_state=1)
B = Rotation.random(50, random_state=2)
VECTORS: FloatArray = np.random.default_rng(3).normal(size=(50, 3))


def same(found: FloatArray, expected: Rotation) -> bool:
    return bool(np.allclose(Rotation.from_quat(found).as_matrix(), expected.as_matrix()))


def test_product_inverse_and_image_are_scipys() -> None:
    assert same(rotations.multiply(A.as_quat(), B.as_quat()), A * B)
    assert same(rotations.inverse(A.as_quat()), A.inv())
    assert np.allclose(rotations.rotate(A.as_quat(), VECTORS), A.apply(VECTORS))
    assert same(rotations.multiply_parts(A.as_quat().T, B.as_quat().T).T, A * B)


def test_many_rotations_of_one_vector_are_those_of_as_many() -> None:
    both = np.stack((A.as_quat(), -A.as_quat()))
    assert np.allclose(rotations.images(both, VECTORS[:1]), A.apply(VECTORS[0]).T)


def test_rotation_vectors_go_there_and_back() -> None:
    assert np.allclose(rotations.to_rotation_vector(A.as_quat()), A.as_rotvec())
    assert same(rotations.from_rotation_vector(A.as_rotvec()), A)
    assert np.allclose(rotations.to_rotation_vector(rotations.IDENTITY), 0)


def test_axes_give_the_rotation_that_has_them() -> None:
    matrices = A.as_matrix()
    assert same(rotations.from_axes(*(matrices[..., column] for column in range(3))), A)


@pytest.mark.parametrize("target", [VECTORS[::-1], VECTORS, -VECTORS], ids=["any", "the same", "opposite"])
def test_between_takes_one_direction_to_the_other(target: FloatArray) -> None:
    turned = rotations.rotate(rotations.shortest_rotation(VECTORS, target), VECTORS)
    assert np.allclose(np.cross(turned, target), 0, atol=1e-6)
    assert np.all(np.sum(turned * target, axis=-1) > 0)


def test_slerp_goes_the_shorter_way_at_an_even_pace() -> None:
    a, b = A.as_quat(), -B.as_quat()
    half = rotations.slerp(a, b, np.full(50, 0.5))
    assert same(rotations.slerp(a, b, np.ones(50)), B)
    assert np.allclose(rotations.angle_between(a, half), rotations.angle_between(a, b) / 2)


def test_continuous_signs_leaves_no_flip() -> None:
    smooth = rotations.from_axis_angle((0.0, 1.0, 0.0), np.linspace(0, 3, 20))
    flipped = smooth * np.where(np.arange(20) % 3 == 0, -1.0, 1.0)[:, None]
    found = rotations.with_continuous_signs(flipped)
    assert np.all(np.sum(found[1:] * found[:-1], axis=-1) > 0)
    assert same(found, Rotation.from_quat(smooth))


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
