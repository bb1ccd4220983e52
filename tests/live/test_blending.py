"""Going over from one motion to another."""

import numpy as np
import pytest

from understudy.live.blending import FACE_S, LONGEST_S, SPEED, Offset, Pose
from understudy.realizer.geometry.rotations import angle_between, from_axis_angle

FRAME_S = 1 / 60
X = (1.0, 0.0, 0.0)


def poses(angles: list[float], hips: list[float]) -> Pose:
    rotations = from_axis_angle(X, np.array(angles))[:, None]
    return Pose(rotations, np.array(hips)[:, None] * np.ones(3), np.zeros((len(angles), 52)))


def still(count: int) -> Pose:
    return poses([0.0] * count, [0.0] * count)


def test_it_begins_where_the_old_motion_was_as_fast_as_that_and_ends_on_the_new() -> None:
    shown = poses([0.98, 1.0], [0.09, 0.1])
    offset = Offset.between(shown, still(2), at_s=0.0, frame_s=FRAME_S)
    times_s = np.arange(1, round(LONGEST_S / FRAME_S) + 3) * FRAME_S
    blended = offset.added(still(len(times_s)), times_s)
    angles = angle_between(blended.rotations[:, 0], still(len(times_s)).rotations[:, 0])
    assert angles[0] == pytest.approx(1.02, abs=0.005)
    assert blended.hips_m[0] == pytest.approx(0.11, abs=0.002)
    assert angles[-1] == pytest.approx(0, abs=1e-6)
    assert blended.hips_m[-1] == pytest.approx(0, abs=1e-9)
    assert np.abs(np.diff(angles)).max() < (SPEED + 0.02 / FRAME_S) * FRAME_S


def test_later_the_new_motion_is_not_touched() -> None:
    offset = Offset.between(poses([0.0, 1.0], [0.0, 1.0]), still(2), at_s=0.0, frame_s=FRAME_S)
    motion = still(3)
    assert offset.added(motion, LONGEST_S + np.arange(3.0)) is motion


def test_weights_of_the_face_stay_within_their_bounds() -> None:
    shown, new = still(2), still(2)
    shown = Pose(shown.rotations, shown.hips_m, np.ones((2, 52)))
    offset = Offset.between(shown, new, at_s=0.0, frame_s=FRAME_S)
    times_s = np.arange(0.0, 2 * FACE_S, FRAME_S)
    full = still(len(times_s))
    blended = offset.added(Pose(full.rotations, full.hips_m, np.ones((len(times_s), 52))), times_s)
    assert blended.shapes.max() == 1.0
