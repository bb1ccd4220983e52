"""Fewer keys: what is left plays within the tolerance of what was there."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation, Slerp

from understudy.model import FloatArray
from understudy.realizer.exporting.keyframes import rotation_keys, value_keys
from understudy.realizer.geometry.rotations import with_continuous_signs


def wandering(frames: int, seed: int) -> FloatArray:
    """Rotations (T, 4) that turn about one axis and another, slowly and fast."""
    chance = np.random.default_rng(seed)
    times = np.linspace(0, 6, frames)
    waves = [np.sin(times * chance.uniform(0.5, 8) + chance.uniform(0, 6)) for _axis in range(3)]
    return with_continuous_signs(np.asarray(Rotation.from_rotvec(np.stack(waves, axis=-1)).as_quat()))


@pytest.mark.parametrize("seed", range(4))
@pytest.mark.parametrize("tolerance_deg", [0.1, 1.0, 5.0])
def test_rotations_between_keys_are_within_the_tolerance(seed: int, tolerance_deg: float) -> None:
    """Played by scipy's slerp."""
    rotations = wandering(400, seed)
    kept = rotation_keys(rotations, np.radians(tolerance_deg))
    played = Slerp(kept, Rotation.from_quat(rotations[kept]))(np.arange(400))
    apart = (Rotation.from_quat(rotations).inv() * played).magnitude()
    assert np.degrees(apart.max()) <= tolerance_deg + 1e-6
    assert len(kept) < 400


def test_fewer_keys_for_more_tolerance_and_none_that_a_line_does_not_need() -> None:
    rotations = wandering(400, 1)
    counts = [len(rotation_keys(rotations, np.radians(degrees))) for degrees in (0.1, 0.5, 2.0, 10.0)]
    assert counts == sorted(counts, reverse=True)
    assert counts[0] > 2 * counts[-1]
    steady = np.asarray(Rotation.from_rotvec(np.outer(np.linspace(0, 2, 50), [0, 1, 0])).as_quat())
    assert rotation_keys(steady, 1e-6).tolist() == [0, 49]


def test_values_between_keys_are_within_the_tolerance_of_all_of_them() -> None:
    times = np.arange(300)
    values = np.stack([np.sin(times / 9), np.where(times == 150, 1.0, 0.0), times / 300], axis=1)
    kept = value_keys(values, 0.02)
    played = np.stack([np.interp(times, kept, values[kept, k]) for k in range(3)], axis=1)
    assert np.abs(played - values).max() <= 0.02
    assert {149, 150, 151} <= set(kept.tolist())
    assert len(kept) < 100


@pytest.mark.parametrize("frames", [1, 2])
def test_the_shortest_tracks_keep_their_frames(frames: int) -> None:
    assert len(rotation_keys(wandering(400, 0)[:frames], 0.1)) == frames
    assert len(value_keys(np.zeros((frames, 3)), 0.1)) == frames
