"""The mannequin's skin follows its joints."""

import numpy as np
import pytest

from understudy.model import FloatArray
from understudy.realizer.body.motion import SHAPES
from understudy.realizer.body.skeleton import HIPS_HEIGHT_M, Skeleton
from understudy.realizer.geometry.rotations import IDENTITY, from_axis_angle
from understudy.realizer.mannequin.mannequin import Mannequin, posed

BODY = Skeleton.standing()
HIPS = np.array([0.0, HIPS_HEIGHT_M, 0.0])
AT_REST = np.zeros(len(SHAPES))


@pytest.fixture(scope="module")
def mannequin() -> Mannequin:
    return Mannequin.around(BODY)


def points(mannequin: Mannequin, turned: dict[str, FloatArray] | None = None) -> FloatArray:
    rotations = np.tile(IDENTITY, (len(BODY.names), 1))
    for joint, rotation in (turned or {}).items():
        rotations[BODY.index[joint]] = rotation
    return np.concatenate([part.positions_m for part in posed(mannequin, rotations, HIPS, AT_REST)])


def test_weights_sum_to_one_and_each_vertex_follows_joints_that_are_there(mannequin: Mannequin) -> None:
    for part in mannequin.parts:
        assert part.weights.sum(axis=1) == pytest.approx(1.0)
        assert part.weights.min() >= 0
        assert part.joints.max() < len(BODY.names)


def test_in_the_t_pose_it_stands_on_the_ground_as_tall_as_its_skeleton_says(mannequin: Mannequin) -> None:
    at = points(mannequin)
    assert at[:, 1].min() == pytest.approx(0.0, abs=0.015)
    assert at[:, 1].max() == pytest.approx(1.73, abs=0.02)
    assert np.allclose(at, np.concatenate([part.surface.positions_m for part in mannequin.parts]))


def test_left_and_right_are_mirror_images(mannequin: Mannequin) -> None:
    at = points(mannequin)
    assert at[:, 0].max() == pytest.approx(-at[:, 0].min(), abs=0.002)
    assert np.mean(at[:, 0]) == pytest.approx(0.0, abs=0.002)


def test_a_bent_elbow_moves_the_hand_and_leaves_the_rest(mannequin: Mannequin) -> None:
    before = points(mannequin)
    after = points(mannequin, {"leftLowerArm": from_axis_angle((0.0, 1.0, 0.0), np.array(-np.pi / 2))})
    moved = np.linalg.norm(after - before, axis=1) > 1e-3
    elbow_m = 0.45
    assert before[moved, 0].min() > elbow_m - 0.08
    assert moved[before[:, 0] > elbow_m + 0.06].all()
    assert after[:, 2].max() > 0.35
