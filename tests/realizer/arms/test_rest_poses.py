"""Hands at rest: where they are said to be, in easy joints, clear of the body and of each other."""

from itertools import combinations

import numpy as np
import pytest

from understudy.model import FloatArray, Hand, Level
from understudy.model.figure import Wait
from understudy.realizer.arms.posing import wrist_of
from understudy.realizer.arms.rest_poses import RESTS, rest_pose, waiting_pose
from understudy.realizer.body.contacts import PosedBody, contacts
from understudy.realizer.body.limits import violations
from understudy.realizer.body.skeleton import Skeleton, arm_joints
from understudy.realizer.geometry.rotations import IDENTITY, angle_between

BODY = Skeleton.standing()
SIDES = (Hand.LEFT, Hand.RIGHT)


def resting(name: str) -> FloatArray:
    rotations = np.tile(IDENTITY, (1, len(BODY.names), 1))
    for side in SIDES:
        rotations[0, BODY.chain(*arm_joints(side))] = rest_pose(BODY, side, name).rotations
    return rotations


@pytest.mark.parametrize("name", RESTS)
def test_wrists_are_where_the_pose_says_within_the_limits_of_the_joints(name: str) -> None:
    assert violations(BODY, resting(name)).max() == 0
    for side in SIDES:
        pose = rest_pose(BODY, side, name)
        assert np.allclose(wrist_of(BODY, side, pose.rotations), pose.wrist_m, atol=0.01)


@pytest.mark.parametrize("name", RESTS)
def test_hands_have_room_to_stir(name: str) -> None:
    found = contacts(BODY, PosedBody.of(BODY, resting(name), np.zeros((1, 3))))
    assert found.depth_m.max() < -0.01


@pytest.mark.parametrize("level", Level)
def test_hands_wait_in_six_uneven_ways_that_are_told_apart(level: Level) -> None:
    """By 10 cm of a wrist, seen from the body, and none of them is its own mirror image."""
    uneven = [wait for wait in Wait if wait is not Wait.BELLY]
    ways = [waiting_pose(wait, level, side) for wait in uneven for side in SIDES]
    places_m = [np.array([rest_pose(BODY, side, name).wrist_m for side in SIDES]) for name in ways]
    assert len(uneven) >= 6
    for one_m, other_m in combinations(places_m, 2):
        assert np.linalg.norm(one_m - other_m, axis=1).max() > 0.10


@pytest.mark.parametrize("name", RESTS)
def test_no_elbow_is_locked_and_no_finger_is_stiff(name: str) -> None:
    for side in SIDES:
        rotations = rest_pose(BODY, side, name).rotations
        assert angle_between(rotations[2], IDENTITY) > np.radians(12)
        assert rest_pose(BODY, side, name).as_partial().defined.all()
