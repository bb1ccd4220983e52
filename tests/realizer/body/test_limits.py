"""Joint limits: measured as anatomy says on either side, kept where they are passed, and else nothing is touched."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from understudy.model import FloatArray
from understudy.realizer.body.limits import (
    LIMITS,
    clamp,
    shoulder_deg,
    swing_twist_deg,
    violations,
    within_shoulder_limits,
)
from understudy.realizer.body.skeleton import Skeleton
from understudy.realizer.geometry.rotations import IDENTITY, from_axis_angle, from_rotation_vector, multiply, rotate

BODY = Skeleton.standing()
DOWN = from_axis_angle((0.0, 0.0, 1.0), np.array(-np.pi / 2))
X: FloatArray = np.array([1.0, 0.0, 0.0])


def turned(joint: str, degrees: tuple[float, float, float]) -> FloatArray:
    """The body in its T-pose but for one joint, turned by a rotation vector."""
    rotations = np.tile(IDENTITY, (len(BODY.names), 1))
    rotations[BODY.index[joint]] = from_rotation_vector(np.radians(degrees))
    return rotations


def passed(rotations: FloatArray) -> dict[tuple[str, ...], float]:
    found = violations(BODY, rotations)
    return {LIMITS[column].joints: float(found[column]) for column in np.nonzero(found)[0]}


@pytest.mark.parametrize(
    ("joint", "degrees", "over"),
    [
        ("leftHand", (0.0, 0.0, -85.0), 5.0),
        ("leftHand", (0.0, 0.0, 69.0), 0.0),
        ("leftHand", (0.0, 35.0, 0.0), 5.0),
        ("rightHand", (0.0, 0.0, 85.0), 5.0),
        ("rightHand", (0.0, 0.0, -69.0), 0.0),
        ("leftLowerArm", (0.0, -160.0, 0.0), 10.0),
        ("leftLowerArm", (0.0, 10.0, 0.0), 10.0),
        ("rightLowerArm", (0.0, 149.0, 0.0), 0.0),
        ("rightLowerArm", (-90.0, 0.0, 0.0), 10.0),
        ("leftIndexIntermediate", (0.0, 0.0, -116.0), 1.0),
        ("head", (0.0, 70.0, 0.0), 10.0),
        ("head", (44.0, 0.0, 0.0), 0.0),
    ],
)
def test_a_joint_just_past_its_limit_is_told_by_how_much(
    joint: str, degrees: tuple[float, float, float], over: float
) -> None:
    found = passed(turned(joint, degrees))
    assert sum(found.values()) == pytest.approx(over, abs=1e-6)
    assert all(joint in joints for joints in found)


def test_shoulders_are_measured_from_an_arm_that_hangs() -> None:
    forward = multiply(from_axis_angle((-1.0, 0.0, 0.0), np.radians(np.array(90.0))), DOWN)
    assert np.allclose(rotate(forward, X), [0, 0, 1])
    assert np.allclose(shoulder_deg(DOWN), 0)
    assert np.allclose(shoulder_deg(IDENTITY), [0, 0, 90])
    assert np.allclose(shoulder_deg(forward), [-90, 0, 0])
    turned_in = multiply(DOWN, from_axis_angle((1.0, 0.0, 0.0), np.radians(np.array(40.0))))
    assert np.allclose(np.abs(shoulder_deg(turned_in)), [0, 40, 0])


def test_parting_gives_a_twist_and_a_bend_that_make_the_rotation_again() -> None:
    rotations = Rotation.random(200, random_state=6).as_quat()
    for bone in range(3):
        angles = np.radians(swing_twist_deg(rotations, bone))
        twist, bend = np.zeros_like(angles), angles.copy()
        twist[:, bone], bend[:, bone] = angles[:, bone], 0.0
        again = multiply(from_rotation_vector(bend), from_rotation_vector(twist))
        assert np.allclose(np.abs(np.sum(again * rotations, axis=-1)), 1.0)


def test_clamping_brings_trunk_neck_and_arms_back_and_leaves_the_rest_alone() -> None:
    wild = np.tile(IDENTITY, (50, len(BODY.names), 1))
    chance = np.random.default_rng(2)
    for limit in LIMITS:
        for joint in BODY.chain(*limit.joints):
            wild[:, joint] = from_rotation_vector(chance.normal(scale=0.4, size=(50, 3)))
    kept = wild.copy()
    clamp(BODY, kept)
    fingers = [column for column, limit in enumerate(LIMITS) if "al" in limit.joints[0] or "Inter" in limit.joints[0]]
    over = violations(BODY, kept)
    assert violations(BODY, wild).max() > 10
    assert np.delete(over, fingers, axis=1).max() < 1e-3
    easy = turned("leftHand", (0.0, 5.0, 20.0))[None]
    kept = easy.copy()
    clamp(BODY, kept)
    assert np.array_equal(kept, easy)


def test_an_upper_arm_within_its_limits_is_not_touched() -> None:
    assert np.array_equal(within_shoulder_limits(DOWN[None]), DOWN[None])
    behind = multiply(from_axis_angle((1.0, 0.0, 0.0), np.radians(np.array([100.0]))), DOWN)
    assert shoulder_deg(within_shoulder_limits(behind))[0, 0] == pytest.approx(60)
