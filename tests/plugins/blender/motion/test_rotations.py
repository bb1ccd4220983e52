"""Rotations against Rodrigues' formula, which the code does not use."""

import numpy as np
import pytest

from plugins.blender.motion.rotations import matrices, quaternions, shortest, with_continuous_signs
from tests.plugins.blender.clips import X, Y, Z, about, matrix_of


@pytest.mark.parametrize("axis", [X, Y, Z, X + Y, -X + 2 * Y + Z])
@pytest.mark.parametrize("angle_rad", [0.0, 0.3, 2.0, np.pi - 1e-6, np.pi])
def test_matrix_to_quaternion_and_back(axis: np.ndarray, angle_rad: float) -> None:
    turn = about(axis, angle_rad)
    (found,) = quaternions(turn[None])
    assert np.allclose(matrix_of(found), turn, atol=1e-6)
    assert np.allclose(matrices(found), turn, atol=1e-9)


def test_a_full_turn_has_no_jump_of_sign() -> None:
    turns = np.array([about(Z, angle) for angle in np.linspace(0, 2 * np.pi, 37)])
    found = quaternions(turns)
    assert np.all(np.sum(found[1:] * found[:-1], axis=1) > 0.99)
    assert np.allclose(found[-1], -found[0], atol=1e-9)


def test_signs_follow_the_one_before() -> None:
    one = np.array([[1.0, 0, 0, 0], [-1.0, 0, 0, 0], [1.0, 0, 0, 0], [-1.0, 0, 0, 0]])
    assert np.array_equal(with_continuous_signs(one), np.tile(one[0], (4, 1)))


@pytest.mark.parametrize(("start", "end"), [(X, Y), (X, X), (Y, -Y), (X + Y, 3 * Z)])
def test_the_shortest_rotation_arrives(start: np.ndarray, end: np.ndarray) -> None:
    turn = shortest(start, end)
    assert np.allclose(turn @ start / np.linalg.norm(start), end / np.linalg.norm(end))
    assert np.isclose(np.linalg.det(turn), 1)
