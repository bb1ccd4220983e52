"""Few keys, and what lies between them as near as is promised."""

import numpy as np
import pytest

from plugins.blender.motion.sparse_keys import ROTATION_RAD, rotation_frames, value_frames

TIMES = np.linspace(0, 2, 121)


def test_a_straight_way_needs_its_ends_alone() -> None:
    assert value_frames(np.stack([TIMES, 3 * TIMES], axis=1), 0.001) == [0, 120]


def test_a_corner_gets_a_key() -> None:
    assert value_frames(np.abs(TIMES - 1)[:, None], 0.001) == [0, 60, 120]


@pytest.mark.parametrize("tolerance", [0.01, 0.05])
def test_between_keys_nothing_is_further_than_the_tolerance(tolerance: float) -> None:
    values = np.sin(5 * TIMES)[:, None]
    kept = value_frames(values, tolerance)
    between = np.interp(np.arange(121), kept, values[kept, 0])
    assert np.abs(between - values[:, 0]).max() <= tolerance
    assert len(kept) < 60


def test_rotations_are_kept_within_the_angle() -> None:
    angles = 0.8 * np.sin(3 * TIMES)
    turns = np.stack([np.cos(angles / 2), np.sin(angles / 2), 0 * angles, 0 * angles], axis=1)
    kept = rotation_frames(turns)
    between = np.stack([np.interp(np.arange(121), kept, turns[kept, part]) for part in range(4)], axis=1)
    between /= np.linalg.norm(between, axis=1, keepdims=True)
    apart = 2 * np.arccos(np.clip(np.abs(np.einsum("ij,ij->i", between, turns)), 0, 1))
    assert apart.max() <= ROTATION_RAD
    assert 4 < len(kept) < 50
