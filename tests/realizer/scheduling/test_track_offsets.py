"""Offset tracks on a body whose gesture is hand-made: what is added, when, on which side."""

from dataclasses import replace

import numpy as np
import pytest

from tests.realizer.scheduling.test_gesture_controller import RATE_HZ, SKELETON, still
from tests.support.motion.gesture_clips import MARKERS, clip, gesture, library
from understudy.model import FloatArray, Hand, Schedule
from understudy.realizer.body.motion import BodyMotion
from understudy.realizer.geometry.rotations import inverse, multiply, to_rotation_vector
from understudy.realizer.gestures.gesture import Clip, OffsetTrack, TrackForm
from understudy.realizer.scheduling.gesture_controller import apply_gestures
from understudy.realizer.scheduling.planning import plan_gestures
from understudy.realizer.scheduling.track_offsets import track_course, with_tracks

TURN = OffsetTrack(TrackForm.HELD, "chest", (0.0, 12.0, 0.0))
ARC = OffsetTrack(TrackForm.CURVED, "UpperArm", (0.0, 0.0, 10.0))
ROUND = OffsetTrack(TrackForm.CIRCLING, "LowerArm", (0.0, 12.0, 0.0), turns=2.0)


def added_degrees(track: OffsetTrack, joint: str, hand: Hand = Hand.RIGHT) -> FloatArray:
    """What a track adds to a joint (T, 3), as rotation vectors: the difference of the motions with it and without."""
    plain = clip(hand=hand)
    with_track, without = (_moved(each, hand) for each in (replace(plain, tracks=(track,)), plain))
    row = SKELETON.index[joint]
    return np.degrees(to_rotation_vector(multiply(inverse(without.rotations[:, row]), with_track.rotations[:, row])))


def _moved(played: Clip, hand: Hand) -> BodyMotion:
    clips = library(played)
    behaviors = (gesture("g", 2.0, 2.5, hand=hand),)
    plan = plan_gestures(clips, Schedule(behaviors, 6.0), seed=0)
    return apply_gestures(SKELETON, still(plan), plan, seed=0)


@pytest.mark.parametrize(("hand", "degrees"), [(Hand.LEFT, 12.0), (Hand.RIGHT, -12.0), (Hand.BOTH, -12.0)])
def test_the_body_turns_once_to_the_side_of_the_leading_hand(hand: Hand, degrees: float) -> None:
    added = added_degrees(TURN, "chest", hand)
    assert added[np.argmax(np.abs(added[:, 1])), 1] == pytest.approx(degrees)
    np.testing.assert_allclose(added[[0, -1]], 0, atol=1e-9)
    np.testing.assert_allclose(added[:, [0, 2]], 0, atol=1e-9)


def test_both_arms_of_a_gesture_have_its_arcs_as_mirror_images() -> None:
    left, right = (added_degrees(ARC, side + "UpperArm", Hand.BOTH) for side in ("left", "right"))
    assert left[:, 2].max() == pytest.approx(10, abs=0.1)
    np.testing.assert_allclose(right, left * [1, -1, -1], atol=1e-9)


def test_the_other_arm_of_a_gesture_of_one_hand_has_none() -> None:
    np.testing.assert_allclose(added_degrees(ARC, "leftUpperArm", Hand.RIGHT), 0, atol=1e-9)


def test_an_arc_is_there_only_within_the_stroke() -> None:
    times_s = np.array([0.0, 0.5, 0.75, 1.0, 1.3])
    np.testing.assert_allclose(track_course(ARC, MARKERS, times_s), [0, 0, 1, 0, 0], atol=1e-12)


def test_what_is_held_stays_until_the_hand_relaxes() -> None:
    times_s = np.array([0.0, 1.0, 1.1, 1.2, 1.6])
    np.testing.assert_allclose(track_course(TURN, MARKERS, times_s), [0, 1, 1, 1, 0], atol=1e-12)


def test_circles_go_round_as_often_as_they_say_and_begin_and_end_gently() -> None:
    times_s = np.linspace(0.5, 1.0, 500, endpoint=False)
    course = track_course(ROUND, MARKERS, times_s)
    assert np.count_nonzero(np.diff(np.sign(course[1:]))) == 3, "two turns have four halves"
    assert np.abs(course).max() <= 1
    assert abs(course[1]) < 1e-6
    ahead = track_course(replace(ROUND, phase_deg=90.0), MARKERS, np.array([0.75]))
    assert ahead[0] == pytest.approx(np.sin(2 * np.pi + np.pi / 2))


def test_an_offset_goes_slowly_where_a_gesture_blends_into_the_next() -> None:
    blended = replace(MARKERS, end=MARKERS.relax)
    course = track_course(TURN, blended, np.arange(0.0, 2.0, 1 / RATE_HZ))
    assert np.abs(np.diff(course)).max() < 0.1


def test_a_key_pose_is_drawn_with_its_offset() -> None:
    pose = np.tile([0.0, 0.0, 0.0, 1.0], (len(SKELETON.names), 1))
    played = replace(clip(hand=Hand.LEFT), tracks=(TURN, ARC))
    drawn = with_tracks(SKELETON, pose, played, MARKERS.stroke_end)
    moved = np.flatnonzero(np.abs(drawn - pose).max(axis=1) > 1e-6)
    assert [SKELETON.names[row] for row in moved] == ["chest"]
