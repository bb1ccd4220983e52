"""Arms in time: marked keys on time, shoulder before fingers, parts by themselves, holds that stir and do not drift."""

import numpy as np
import pytest

from understudy.model import FloatArray, Hand
from understudy.realizer.arms.interpolation import FOLLOW_THROUGH_S, ArmTrack, TimedPose, arm_motion
from understudy.realizer.arms.posing import PartialPose, arm_rotations, pose_arm, wrist_of
from understudy.realizer.arms.rest_poses import rest_pose
from understudy.realizer.body.skeleton import PARTS, Skeleton
from understudy.realizer.geometry.rotations import angle_between
from understudy.realizer.gestures.gesture import ArmKey, Depth, HandForm, HandShape, HeightSector, SectorPlace, Sideways

BODY = Skeleton.standing()
UP = SectorPlace(Sideways.C, HeightSector.UPPER_C, Depth.MIDDLE)
DOWN = SectorPlace(Sideways.C, HeightSector.LOWER_C, Depth.MIDDLE)
TIMES_S: FloatArray = np.arange(0.0, 4.0, 1 / 60)
JOINTS = [part for part in PARTS if part != "Elbow"]


def rest() -> PartialPose:
    return rest_pose(BODY, Hand.RIGHT, "at_side").as_partial()


def pose(place: SectorPlace, hand: HandForm | None = HandForm.FLAT) -> PartialPose:
    return pose_arm(BODY, Hand.RIGHT, ArmKey(place, None if hand is None else HandShape(hand)))


def beat(*, noise: float = 0.0, follow_through: bool = True) -> ArmTrack:
    """Rest, up at 1 s, the stroke's end at 1.5 s held till 2.5 s, and back."""
    keys = (
        TimedPose(0.2, rest(), follow_through),
        TimedPose(1.0, pose(UP), follow_through, marked=True),
        TimedPose(1.5, pose(DOWN), follow_through, marked=True, noise=noise),
        TimedPose(2.5, pose(DOWN), follow_through, noise=noise),
        TimedPose(3.4, rest(), follow_through),
    )
    return ArmTrack(Hand.RIGHT, keys)


def test_a_marked_key_is_reached_on_its_frame_by_arm_and_wrist() -> None:
    found = arm_motion(beat(), np.array([1.5]), seed=0)[0]
    asked = arm_rotations(pose(DOWN).over(rest()).parts)
    off = angle_between(found, asked)
    assert np.all(off[[1, 2]] < 1e-6)
    assert np.linalg.norm(wrist_of(BODY, Hand.RIGHT, found) - wrist_of(BODY, Hand.RIGHT, asked)) < 0.01


def middles_s(track: ArmTrack, joint: str, start_s: float, end_s: float) -> float:
    """When a joint is half-way from where it is at `start_s` to where it is at `end_s`."""
    times_s = np.arange(start_s, end_s, 1 / 240)
    course = arm_motion(track, times_s, seed=0)[:, JOINTS.index(joint)]
    done = angle_between(course, course[0]) / angle_between(course[-1], course[0])
    return float(times_s[np.argmax(done > 0.5)])


def test_movement_passes_from_the_shoulder_to_the_fingers_within_nine_frames() -> None:
    order = ["Shoulder", "UpperArm", "IndexProximal", "IndexDistal"]
    fist = ArmTrack(
        Hand.RIGHT,
        (
            TimedPose(0.2, rest()),
            TimedPose(1.2, pose(SectorPlace(Sideways.P, HeightSector.UPPER_EP, Depth.MIDDLE), HandForm.FIST)),
            TimedPose(2.4, rest()),
        ),
    )
    middles = [middles_s(fist, joint, 0.0, 1.2) for joint in order]
    assert middles == sorted(middles)
    assert middles[0] < middles[-1] <= middles[0] + FOLLOW_THROUGH_S
    together = ArmTrack(fist.side, tuple(TimedPose(key.time_s, key.pose, False) for key in fist.keys))
    at_key = arm_motion(together, np.array([1.2]), seed=0)[0]
    asked = fist.keys[1].pose.over(rest()).parts
    assert np.all(angle_between(at_key, arm_rotations(asked))[[0, 1, 4, 10]] < 1e-6)


def test_a_hold_does_not_drift_and_noise_stirs_it_a_little() -> None:
    held_s = np.arange(1.65, 2.35, 1 / 60)
    still = wrist_of(BODY, Hand.RIGHT, arm_motion(beat(follow_through=False), held_s, seed=0))
    assert np.ptp(still, axis=0).max() < 1e-6
    stirred = arm_motion(beat(noise=1.0, follow_through=False), held_s, seed=0)
    moved_m = np.ptp(wrist_of(BODY, Hand.RIGHT, stirred), axis=0).max()
    assert 0.001 < moved_m < 0.03
    assert np.all(angle_between(stirred[1:], stirred[:-1]).max(axis=1) > 1e-5)


def test_what_no_key_says_flows_on_between_those_that_do() -> None:
    fist = pose_arm(BODY, Hand.RIGHT, ArmKey(hand=HandShape(HandForm.FIST)))
    keys = (
        TimedPose(0.0, rest(), False),
        TimedPose(1.0, pose(UP, None), False),
        TimedPose(2.0, fist, False),
    )
    found = arm_motion(ArmTrack(Hand.RIGHT, keys), np.array([0.0, 1.0, 2.0]), seed=0)
    index = JOINTS.index("IndexProximal")
    assert 0.2 < angle_between(found[0], found[1])[index] / angle_between(found[0], found[2])[index] < 0.8
    assert np.allclose(found[1, 1], found[2, 1])


def test_frames_are_of_one_sign_never_jump_and_repeat_with_the_seed() -> None:
    track = beat(noise=1.0)
    found = arm_motion(track, TIMES_S, seed=3)
    assert np.all(np.sum(found[1:] * found[:-1], axis=-1) > 0)
    assert angle_between(found[1:], found[:-1]).max() * 60 < 20
    assert np.array_equal(found, arm_motion(track, TIMES_S, seed=3))
    assert not np.array_equal(found, arm_motion(track, TIMES_S, seed=4))


def test_a_track_begins_whole_and_goes_on_in_time() -> None:
    with pytest.raises(ValueError, match="whole arm"):
        ArmTrack(Hand.LEFT, (TimedPose(0.0, pose(UP)),))
    with pytest.raises(ValueError, match="rising"):
        ArmTrack(Hand.LEFT, (TimedPose(0.0, rest()), TimedPose(0.0, rest())))
