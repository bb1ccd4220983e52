"""Ways of an arm between its keys: within the shoulder's limits, so that nothing turns over when it is brought back."""

from dataclasses import replace

import numpy as np
import pytest

from tests.support.motion.motion_limits import broken_limits, wrist_speeds_m_s
from understudy.model import Behavior, Channel, FloatArray, Hand, Level, Manner, Schedule, SyncPoints
from understudy.models import load_realizer
from understudy.realizer.arms.interpolation import ArmTrack, TimedPose, arm_motion
from understudy.realizer.arms.posing import PartialPose
from understudy.realizer.arms.rest_poses import rest_pose
from understudy.realizer.arms.shoulder_ways import within_the_shoulder
from understudy.realizer.body.contacts import penetrations_m
from understudy.realizer.body.limits import MIRROR, shoulder_turned, within_shoulder_limits
from understudy.realizer.body.skeleton import Skeleton
from understudy.realizer.geometry.rotations import angle_between, inverse, multiply
from understudy.realizer.realizing import realize

BODY = Skeleton.standing()
SIDES = (Hand.LEFT, Hand.RIGHT)
WOUND_UP_DEG = (-141.0, -69.0, -53.0)
"""A palm lifted to the head before it comes down, in the biggest manner."""
RATE_HZ = 60


def hip_to_head(side: Hand) -> tuple[TimedPose, ...]:
    """A hand that leaves the hip at 0 and is at the head at 1 s."""
    hip = rest_pose(BODY, side, "on_hips").as_partial()
    parts = hip.parts.copy()
    wound_up = shoulder_turned(np.array(WOUND_UP_DEG))
    parts[1] = multiply(inverse(parts[0]), wound_up if side is Hand.LEFT else wound_up * MIRROR)
    return TimedPose(0.0, hip), TimedPose(1.0, PartialPose(parts))


def limited(side: Hand, keys: tuple[TimedPose, ...]) -> tuple[FloatArray, FloatArray]:
    """The upper arm (T, 4), seen as the left one, on the way and as it is brought back within the limits."""
    moved = arm_motion(ArmTrack(side, keys), np.arange(RATE_HZ + 1) / RATE_HZ, seed=0, noise_scale=0.0)
    orientation = multiply(moved[:, 0], moved[:, 1]) * (1.0 if side is Hand.LEFT else MIRROR)
    return orientation, within_shoulder_limits(orientation)


def fastest_rad_s(orientation: FloatArray) -> float:
    return float(angle_between(orientation[1:], orientation[:-1]).max()) * RATE_HZ


@pytest.mark.parametrize("side", SIDES)
def test_a_hand_gets_from_the_hip_to_the_head_within_the_limits(side: Hand) -> None:
    """The shortest way turns the arm over where it is brought back."""
    keys = hip_to_head(side)
    assert fastest_rad_s(limited(side, keys)[1]) > 50
    way, brought_back = limited(side, within_the_shoulder(side, keys))
    assert np.degrees(angle_between(way, brought_back)).max() < 5
    assert fastest_rad_s(brought_back) < 8


@pytest.mark.parametrize("side", SIDES)
def test_the_ends_of_a_way_stay(side: Hand) -> None:
    keys = hip_to_head(side)
    more = within_the_shoulder(side, keys)
    assert more[0] is keys[0]
    assert more[-1] is keys[-1]
    assert len(more) == 3


def test_a_key_of_the_hand_in_the_middle_keeps_what_it_says() -> None:
    first, last = hip_to_head(Hand.LEFT)
    parts = np.full_like(first.pose.parts, np.nan)
    parts[4] = last.pose.parts[4]
    _first, middle, _last = within_the_shoulder(Hand.LEFT, (first, TimedPose(0.5, PartialPose(parts), noise=0.5), last))
    assert middle.time_s == 0.5
    assert middle.noise == 0.5
    assert middle.pose.defined.nonzero()[0].tolist() == [1, 4]


@pytest.mark.parametrize("side", SIDES)
def test_ways_within_the_limits_are_left_alone(side: Hand) -> None:
    poses = [rest_pose(BODY, side, name).as_partial() for name in ("on_hips", "lap", "lifted", "at_side", "folded")]
    keys = tuple(TimedPose(float(number), pose) for number, pose in enumerate(poses))
    assert within_the_shoulder(side, keys) == keys


def test_a_palm_is_lifted_from_the_hip_to_the_head() -> None:
    """A performance in which the right arm once turned over, the wrist at 28 m/s; chance hangs on the id."""
    realizer, manner = load_realizer(), Manner(amplitude=2.0, speed=1.18, tension=1.48)
    sync = SyncPoints(0.828, ready=1.278, stroke_start=1.278, stroke=1.57, stroke_end=1.694, relax=1.94, end=2.47)
    palm = Behavior("gesture1", Channel.GESTURE, "PALM_UP", sync, 2, 4, 7.0, hand=Hand.BOTH, amount=0.75, manner=manner)
    palm = replace(palm, moment="moment.gesture.4")
    motion = realize(realizer, Schedule((palm,), 4.29, agitation=Level.HIGH, character="expansive"), seed=1)
    skeleton = realizer.performer("expansive").skeleton
    assert broken_limits(motion, skeleton) == []
    assert wrist_speeds_m_s(motion, skeleton).max() <= 3.0
    assert penetrations_m(skeleton, motion.body.rotations, motion.body.hips_m).max() < 0.01
