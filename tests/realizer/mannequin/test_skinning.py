"""The mannequin's skin follows its joints."""

import numpy as np
import pytest

from understudy.model import FloatArray, Hand
from understudy.realizer.arms.rest_poses import rest_pose
from understudy.realizer.body.motion import SHAPES
from understudy.realizer.body.skeleton import HIPS_HEIGHT_M, Skeleton, arm_joints
from understudy.realizer.geometry.rotations import IDENTITY, from_axis_angle
from understudy.realizer.mannequin.carrying import t_pose_m
from understudy.realizer.mannequin.eyes import BALL_M
from understudy.realizer.mannequin.face import MOUTH_HALF_M
from understudy.realizer.mannequin.skinning import Mannequin, posed

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


def test_shoulders_slope_and_the_waist_is_narrower_than_chest_and_hips(mannequin: Mannequin) -> None:
    rest = np.tile(IDENTITY, (len(BODY.names), 1))
    for side in (Hand.LEFT, Hand.RIGHT):
        rest[BODY.chain(*arm_joints(side))] = rest_pose(BODY, side, "at_side").rotations
    posed_parts = zip(mannequin.parts, posed(mannequin, rest, HIPS, AT_REST), strict=True)
    jumper = np.concatenate([made.positions_m for part, made in posed_parts if part.material == "jumper"])
    top = [jumper[np.abs(np.abs(jumper[:, 0]) - across_m) < 0.012, 1].max() for across_m in (0.07, 0.12, 0.165)]
    assert top[0] > top[1] > top[2]
    assert top[2] < 1.402, "2 cm lower than the level ones of before"
    at = points(mannequin)
    width = {
        height_m: np.ptp(at[(np.abs(at[:, 1] - height_m) < 0.012) & (np.abs(at[:, 0]) < 0.22), 0])
        for height_m in (0.93, 1.10, 1.24)
    }
    assert width[1.10] < 0.96 * width[1.24]
    assert width[1.10] < 0.99 * width[0.93]


def test_eyes_mouth_and_hands_can_be_read_from_some_way_off(mannequin: Mannequin) -> None:
    """Against the measures of before: eyes of 15.2 mm radius, a mouth of 50 mm, hands of 18.9 cm."""
    assert 1.15 <= BALL_M / 0.0152 <= 1.20
    assert 1.15 <= MOUTH_HALF_M / 0.025 <= 1.20
    hand = np.concatenate([part.surface.positions_m for part in mannequin.parts if part.material == "skin"])
    length_m = hand[:, 0].max() - t_pose_m(BODY)[BODY.index["leftHand"], 0]
    assert 1.04 <= length_m / 0.189 <= 1.08
