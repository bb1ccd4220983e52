"""Hands stay out of the body and of each other, smoothly; what is clear is left as it is."""

from dataclasses import replace

import numpy as np
import pytest

from understudy.model import FloatArray, Hand
from understudy.realizer.arms.collisions import Collisions, Intrusion, depths_where_near_m, resolve_collisions
from understudy.realizer.arms.interpolation import ArmTrack, TimedPose, arm_motion
from understudy.realizer.arms.posing import PartialPose, pose_arm
from understudy.realizer.arms.rest_poses import rest_pose
from understudy.realizer.body.contacts import depths_m, penetrations_m
from understudy.realizer.body.limits import violations
from understudy.realizer.body.motion import BodyMotion, Decision
from understudy.realizer.body.skeleton import HIPS_HEIGHT_M, Skeleton, arm_joints
from understudy.realizer.geometry.rotations import IDENTITY, angle_between
from understudy.realizer.gestures.gesture import (
    ArmKey,
    Depth,
    HandForm,
    HandShape,
    HeightSector,
    SectorPlace,
    Sideways,
    Wrist,
)

BODY = Skeleton.standing()
RATE_HZ = 60
TIMES_S: FloatArray = np.arange(0.0, 3.0, 1 / RATE_HZ)
INSIDE = SectorPlace(Sideways.CC, HeightSector.LOWER_C, Depth.NEAR, (0.0, 0.0, -0.12))
BEFORE = SectorPlace(Sideways.P, HeightSector.CC, Depth.FAR)
MIDDLE = SectorPlace(Sideways.CC, HeightSector.CC, Depth.MIDDLE, (-0.06, 0.0, 0.0))


def rest(side: Hand, name: str = "at_side") -> PartialPose:
    return rest_pose(BODY, side, name).as_partial()


def moving(*keys: tuple[Hand, SectorPlace]) -> BodyMotion:
    """Each arm from its side to a place, held from 1 to 1.6 s, and back."""
    rotations = np.tile(IDENTITY, (len(TIMES_S), len(BODY.names), 1))
    places = dict(keys)
    for side in (Hand.LEFT, Hand.RIGHT):
        track = [TimedPose(0.0, rest(side))]
        if side in places:
            pose = pose_arm(BODY, side, ArmKey(places[side], HandShape(HandForm.FLAT), wrist=Wrist()))
            track += [TimedPose(1.0, pose), TimedPose(1.6, pose), TimedPose(2.8, rest(side))]
        rotations[:, BODY.chain(*arm_joints(side))] = arm_motion(ArmTrack(side, tuple(track)), TIMES_S, seed=0)
    return BodyMotion(TIMES_S, rotations, np.tile([0.0, HIPS_HEIGHT_M, 0.0], (len(TIMES_S), 1)))


def deepest_m(body: BodyMotion) -> float:
    return float(penetrations_m(BODY, body.rotations, body.hips_m).max())


@pytest.mark.parametrize(
    "keys",
    [
        ((Hand.LEFT, INSIDE),),
        ((Hand.RIGHT, INSIDE),),
        ((Hand.LEFT, INSIDE), (Hand.RIGHT, BEFORE)),
        ((Hand.LEFT, MIDDLE), (Hand.RIGHT, MIDDLE)),
    ],
    ids=["left", "right", "one of two", "each other"],
)
def test_hands_that_would_be_inside_something_are_kept_out_without_a_jump(
    keys: tuple[tuple[Hand, SectorPlace], ...],
) -> None:
    body = moving(*keys)
    assert deepest_m(body) > 0.02
    cleared = body.copy()
    found = resolve_collisions(BODY, cleared)
    assert deepest_m(cleared) < 0.001
    assert {decision.action for decision in found.decisions} == {"moved"}
    assert "cm inside" in found.decisions[0].reason
    speed = angle_between(cleared.rotations[1:], cleared.rotations[:-1]) * RATE_HZ
    assert speed.max() < 20
    assert np.abs(np.diff(speed, axis=0)).max() < 4
    assert violations(BODY, cleared.rotations).max() == 0
    assert np.all(np.sum(cleared.rotations[1:] * cleared.rotations[:-1], axis=-1) > 0)


def test_what_is_clear_is_left_as_it_is() -> None:
    body = moving((Hand.LEFT, BEFORE), (Hand.RIGHT, BEFORE))
    cleared = body.copy()
    found = resolve_collisions(BODY, cleared)
    assert found.decisions == ()
    assert np.array_equal(cleared.rotations, body.rotations)


def test_a_joint_past_its_limit_is_brought_back() -> None:
    body = moving((Hand.LEFT, BEFORE))
    bent = body.rotations.copy()
    bent[:, BODY.index["leftHand"]] = [0.0, 0.0, np.sin(np.radians(50)), np.cos(np.radians(50))]
    cleared = BodyMotion(TIMES_S, bent.copy(), body.hips_m)
    resolve_collisions(BODY, cleared)
    assert violations(BODY, bent).max() > 25
    assert violations(BODY, cleared.rotations).max() == 0


CHEST = SectorPlace(Sideways.CC, HeightSector.CC, Depth.NEAR, (0.0, 0.0, -0.28))
BELLY = SectorPlace(Sideways.OPP_P, HeightSector.LOWER_P, Depth.NEAR, (0.0, 0.0, -0.35))


def through(place: SectorPlace, there_s: float) -> BodyMotion:
    """The left hand from its side to a place within the body in that time, and straight back."""
    body, start = moving((Hand.LEFT, BEFORE)), rest(Hand.LEFT)
    poses = start, start, pose_arm(BODY, Hand.LEFT, ArmKey(place)).over(start), start
    track = tuple(map(TimedPose, (0.0, 1.0, 1.0 + there_s, 1.0 + 2 * there_s), poses))
    body.rotations[:, BODY.chain(*arm_joints(Hand.LEFT))] = arm_motion(ArmTrack(Hand.LEFT, track), TIMES_S, seed=0)
    return body


@pytest.mark.parametrize(
    ("place", "there_s"),
    [(BELLY, 0.12), (CHEST, 0.07)],
    ids=["belly", "chest, too quickly to be seen again"],
)
def test_what_cannot_be_cleared_without_a_jump_is_told(place: SectorPlace, there_s: float) -> None:
    """A hand that is through the body for a tenth of a second cannot be before it in time."""
    body = through(place, there_s)
    cleared = body.copy()
    found = resolve_collisions(BODY, cleared)
    fastest = [angle_between(each[1:], each[:-1]).max() * RATE_HZ for each in (body.rotations, cleared.rotations)]
    assert fastest[1] <= max(20.0, fastest[0] + 1e-6)
    assert (deepest_m(cleared) > 0.001) == ("kept" in {decision.action for decision in found.decisions})
    assert deepest_m(cleared) < deepest_m(body)


def test_an_arm_goes_another_way_where_it_cannot_leave_in_time() -> None:
    """A hand that is through the chest for a quarter of a second is led beside it."""
    body = through(CHEST, 0.12)
    found = resolve_collisions(BODY, body)
    assert {decision.action for decision in found.decisions} == {"moved"}
    assert deepest_m(body) <= 0.001
    assert angle_between(body.rotations[1:], body.rotations[:-1]).max() * RATE_HZ < 28


@pytest.mark.parametrize("keys", [((Hand.LEFT, INSIDE),), ((Hand.LEFT, MIDDLE), (Hand.RIGHT, MIDDLE))])
def test_no_frame_in_which_a_hand_is_inside_something_is_overlooked(keys: tuple[tuple[Hand, SectorPlace], ...]) -> None:
    body = moving(*keys)
    everywhere, looked_at = depths_m(BODY, body.rotations, body.hips_m), depths_where_near_m(BODY, body)
    assert np.maximum(looked_at, 0.0) == pytest.approx(np.maximum(everywhere, 0.0), abs=1e-12)
    assert np.mean(looked_at.max(axis=1) == -1.0) > 0.3


@pytest.mark.parametrize("shift", range(4))
def test_hands_that_are_in_each_other_for_three_frames_only_are_found(shift: int) -> None:
    """The right hand strikes at the left one and is back a moment later, between two of the frames that are looked
    at."""
    body, start = moving((Hand.LEFT, MIDDLE)), rest(Hand.RIGHT)
    aside, inside = (
        pose_arm(BODY, Hand.RIGHT, ArmKey(place, HandShape(HandForm.FLAT), wrist=Wrist())).over(start)
        for place in (replace(MIDDLE, offset_m=(0.25, 0.0, 0.0)), replace(MIDDLE, offset_m=(0.04, 0.0, 0.0)))
    )
    keys = ((0.0, start), (1.14, aside), (1.2, inside), (1.26, aside), (2.5, start))
    track = ArmTrack(Hand.RIGHT, tuple(TimedPose(*key) for key in keys))
    body.rotations[:, BODY.chain(*arm_joints(Hand.RIGHT))] = arm_motion(track, TIMES_S, seed=0)
    shifted = BodyMotion(TIMES_S[shift:] - TIMES_S[shift], body.rotations[shift:], body.hips_m[shift:])
    inside_m = depths_m(BODY, shifted.rotations, shifted.hips_m).max(axis=1)
    assert 1 <= np.sum(inside_m > 0) <= 3
    assert np.array_equal(depths_where_near_m(BODY, shifted).max(axis=1) > 0, inside_m > 0)


def test_what_is_moved_again_is_told_once_and_what_stays_inside_as_it_is_at_last() -> None:
    left, right = (Intrusion(side, "hand", "torso", 0.02, 1.0, 1.5) for side in ("left", "right"))
    later = replace(left, start_s=1.4, end_s=1.8, deepest_m=0.003)
    kept = Decision("", "kept", "a hand stays 0.5 cm inside something")
    found = Collisions((left,), (kept,)).and_then(Collisions((later, right, replace(left, start_s=3.0, end_s=3.1))))
    assert [(each.side, each.start_s) for each in found.moved] == [("left", 1.0), ("right", 1.0), ("left", 3.0)]
    assert found.kept == ()
