"""The body stands as VRM's T-pose does (shared/motion.md), and turns as the world's axes say."""

import numpy as np
import pytest

from understudy.model import FloatArray, Hand
from understudy.realizer.body.skeleton import HIPS_HEIGHT_M, Skeleton, arm_joints, forward
from understudy.realizer.geometry.rotations import IDENTITY, from_axis_angle

BODY = Skeleton.standing()


def positions(turned: dict[str, FloatArray] | None = None) -> FloatArray:
    rotations = np.tile(IDENTITY, (len(BODY.names), 1))
    for joint, rotation in (turned or {}).items():
        rotations[BODY.index[joint]] = rotation
    return forward(BODY, rotations, np.array([0.0, HIPS_HEIGHT_M, 0.0]))[0]


def test_parents_come_before_their_children() -> None:
    assert all(parent < joint for joint, parent in enumerate(BODY.parents))


def test_t_pose_is_mirrored_faces_forward_and_stands_on_the_ground() -> None:
    at = positions()
    for name, joint in BODY.index.items():
        if name.startswith("left"):
            assert np.allclose(at[joint] * [-1, 1, 1], at[BODY.index["right" + name[4:]]])
    assert at[BODY.index["leftHand"], 0] > 0.6
    assert at[BODY.index["leftEye"], 2] > at[BODY.index["head"], 2]
    assert at[BODY.index["leftToes"], 2] > at[BODY.index["leftFoot"], 2]
    assert 0 <= at[:, 1].min() < 0.05


@pytest.mark.parametrize("side", ["left", "right"])
def test_an_elbow_bent_about_y_brings_the_hand_forward(side: str) -> None:
    angle = -np.pi / 2 if side == "left" else np.pi / 2
    at = positions({f"{side}LowerArm": from_axis_angle((0.0, 1.0, 0.0), np.array(angle))})
    elbow, hand = at[BODY.index[f"{side}LowerArm"]], at[BODY.index[f"{side}Hand"]]
    assert np.allclose(hand - elbow, [0, 0, 0.25])


def test_both_arms_are_a_view_of_a_bodys_rotations_joint_by_joint() -> None:
    rotations = np.random.default_rng(0).normal(size=(5, len(BODY.names), 4))
    arms = BODY.arms(rotations)
    for number, side in enumerate((Hand.LEFT, Hand.RIGHT)):
        assert np.array_equal(arms[:, number], rotations[:, BODY.rows(*arm_joints(side))])
    arms[2, 1, 3] = IDENTITY
    assert np.array_equal(rotations[2, BODY.index["rightHand"]], IDENTITY)


def test_arms_of_rotations_that_would_be_a_copy_are_refused() -> None:
    with pytest.raises(ValueError, match="copy"):
        BODY.arms(np.zeros((4, len(BODY.names), 5)).swapaxes(0, 2)[..., :4])
