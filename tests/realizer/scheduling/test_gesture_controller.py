"""Offset tracks on a body whose gesture is hand-made: what is added, when, on which side."""

from dataclasses import replace

import numpy as np
import pytest

from tests.support.motion.gesture_clips import MARKERS, HandMade, clip, gesture, library, place
from understudy.model import Behavior, FloatArray, Hand, Schedule
from understudy.realizer.arms.arm_keys import arm_track
from understudy.realizer.arms.posing import pose_arm
from understudy.realizer.arms.rest_poses import rest_pose
from understudy.realizer.arms.wrist_paths import relax_m
from understudy.realizer.body.motion import BodyMotion
from understudy.realizer.body.skeleton import Skeleton, arm_joints, forward
from understudy.realizer.geometry.rotations import IDENTITY, angle_between, inverse, multiply, to_rotation_vector
from understudy.realizer.gestures.gesture import ArmKey, Clip, ClipKey, FrameType, OffsetTrack, TrackForm
from understudy.realizer.gestures.gesture_plan import GesturePlan
from understudy.realizer.scheduling.gesture_controller import ARC as ARC_SHARE
from understudy.realizer.scheduling.gesture_controller import apply_gestures, track_course, with_tracks
from understudy.realizer.scheduling.planning import plan_gestures

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


SKELETON = Skeleton.standing()
RATE_HZ = 60


def planned(behaviors: list[Behavior], clips: HandMade, emphases_s: tuple[float, ...] = ()) -> GesturePlan:
    return plan_gestures(clips, Schedule(tuple(behaviors), 6.0, emphases_s=emphases_s), seed=0)


def still(plan: GesturePlan) -> BodyMotion:
    """A body in T-pose, as long as the plan."""
    times_s = np.arange(int(plan.end_s * RATE_HZ) + 1) / RATE_HZ
    rotations = np.tile(IDENTITY, (len(times_s), len(SKELETON.names), 1))
    return BodyMotion(times_s, rotations, np.tile(SKELETON.offsets_m[0], (len(times_s), 1)))


def moved(plan: GesturePlan) -> BodyMotion:
    return apply_gestures(SKELETON, still(plan), plan, seed=0)


def wrist(body: BodyMotion, side: str = "right") -> FloatArray:
    positions, _ = forward(SKELETON, body.rotations, body.hips_m)
    return np.asarray(positions[:, SKELETON.index[f"{side}Hand"]])


def at(time_s: float) -> int:
    return round(time_s * RATE_HZ)


def test_the_arm_strikes_outwards_on_time_and_holds_still_but_not_frozen() -> None:
    plan = planned([gesture("g1", 2.0, 3.2)], library(clip()))
    place_m = wrist(moved(plan))
    outwards_m = -place_m[:, 0]
    (markers,) = (arm.markers for arm in plan.gestures)
    start_m, end_m = outwards_m[at(markers.stroke_start)], outwards_m[at(markers.stroke_end)]
    assert end_m - start_m > 0.2
    held = place_m[at(markers.stroke_end + 0.1) : at(markers.relax - 0.1)]
    assert np.ptp(held, axis=0).max() < 0.03
    assert np.linalg.norm(np.diff(held, axis=0), axis=1).min() > 0


def test_a_relax_frame_that_says_nothing_lets_nothing_go() -> None:
    made = clip()
    silent = replace(made, keys=(*made.keys, ClipKey(made.markers.relax, FrameType.RELAX, ArmKey(), ArmKey())))
    silent = replace(silent, keys=tuple(sorted(silent.keys, key=lambda key: key.time_s)))
    plan = planned([gesture("g1", 2.0, 3.2)], library(silent))
    (markers,) = (arm.markers for arm in plan.gestures)
    held = wrist(moved(plan))[at(markers.stroke_end + 0.1) : at(markers.relax - 0.1)]
    assert np.ptp(held, axis=0).max() < 0.03


def test_the_arm_begins_and_ends_at_rest() -> None:
    plan = planned([gesture("g1", 2.0, 2.6)], library(clip()))
    body = moved(plan)
    for side in (Hand.LEFT, Hand.RIGHT):
        joints = SKELETON.chain(*arm_joints(side))
        first = angle_between(body.rotations[0, joints], rest_pose(SKELETON, side, "at_side").rotations)
        last = angle_between(body.rotations[-1, joints], rest_pose(SKELETON, side, "at_side").rotations)
        assert np.degrees(max(first.max(), last.max())) < 5


def test_no_joint_jumps() -> None:
    behaviors = [gesture("g1", 0.4, 0.9), gesture("g2", 1.7, 2.2), gesture("g3", 2.9, 3.2, hand=Hand.BOTH)]
    body = moved(planned(behaviors, library(clip(), clip("both", hand=Hand.BOTH))))
    speeds_rad_s = angle_between(body.rotations[1:], body.rotations[:-1]) * RATE_HZ
    assert speeds_rad_s.max() < 20
    assert np.linalg.norm(np.diff(wrist(body), axis=0), axis=1).max() * RATE_HZ < 3


def test_a_repetition_goes_back_and_forth_by_its_amplitude() -> None:
    plan = planned([gesture("g1", 2.0, 2.5)], library(clip(category="GREETING")))
    beats = planned([gesture("g1", 2.0, 2.5, lexeme="BEAT")], library(clip(category="BEAT")), (2.9,))
    (arm,) = beats.gestures
    (repeat,) = arm.placed.repeats
    outwards_m = -wrist(moved(beats))[:, 0]
    stroke_m = outwards_m[at(2.2)] - outwards_m[at(1.7)]
    turn_s = (repeat.start_s + repeat.end_s) / 2
    back_m = outwards_m[at(2.2)] - outwards_m[at(turn_s)]
    assert back_m == pytest.approx(repeat.amplitude * stroke_m, rel=0.2)
    assert outwards_m[at(2.9)] == pytest.approx(outwards_m[at(2.2)], abs=0.02)
    assert plan.gestures[0].placed.repeats == ()


def test_the_trunk_turns_to_the_hand_that_reaches_out_and_back() -> None:
    plan = planned([gesture("g1", 2.0, 3.0)], library(clip(to_m=0.3)))
    body = moved(plan)
    yaw = body.rotations[:, SKELETON.index["chest"], 1]
    assert yaw[at(2.6)] < yaw[at(0.5)] - 0.003
    assert abs(yaw[at(5.5)] - yaw[at(0.5)]) < 0.003


def test_keys_of_the_stroke_are_where_the_plan_has_them() -> None:
    plan = planned([gesture("g1", 2.0, 2.6)], library(clip()))
    marked = [key.time_s for key in arm_track(SKELETON, Hand.RIGHT, plan).keys if key.marked]
    assert marked == pytest.approx([1.7, 2.2])


def test_the_same_seed_gives_the_same_motion_and_another_another() -> None:
    plan = planned([gesture("g1", 2.0, 2.6)], library(clip()))
    one, same, other = (apply_gestures(SKELETON, still(plan), plan, seed=seed) for seed in (0, 0, 1))
    assert one.rotations.tobytes() == same.rotations.tobytes()
    assert one.rotations.tobytes() != other.rotations.tobytes()


def test_a_pointing_arm_is_on_the_line_from_the_shoulder_to_its_target() -> None:
    pointing = replace(gesture("g1", 2.0, 3.0), target="door")
    door_m = np.array([-2.0, 1.2, 1.5])
    plan = plan_gestures(
        library(replace(clip(), aimed=True)), Schedule((pointing,), 5.0), seed=0, targets_m={"door": tuple(door_m)}
    )
    positions, _ = forward(SKELETON, (body := moved(plan)).rotations, body.hips_m)
    shoulder_m, wrist_m = positions[at(2.6)][SKELETON.chain("rightUpperArm", "rightHand")]
    way, aim = wrist_m - shoulder_m, door_m - shoulder_m
    cosine = way @ aim / np.linalg.norm(way) / np.linalg.norm(aim)
    assert np.degrees(np.arccos(cosine)) < 8


def test_the_plan_knows_where_a_pointing_wrist_is() -> None:
    pointing = replace(gesture("g1", 2.0, 3.0), target="door")
    plan = plan_gestures(
        library(replace(clip(), aimed=True)), Schedule((pointing,), 5.0), seed=0, targets_m={"door": (-2.0, 1.2, 1.5)}
    )
    (arm,) = plan.gestures
    posed = pose_arm(SKELETON, Hand.RIGHT, ArmKey(place=place(0.3)), aim_m=np.array([-2.0, 1.2 - 0.95, 1.5]))
    assert posed.wrist_m is not None
    np.testing.assert_allclose(relax_m(arm.placed, Hand.RIGHT), posed.wrist_m, atol=0.05)


STROKE_S = 2.0
BEGINS, ENDS = (
    round((STROKE_S + at_s - MARKERS.stroke) * RATE_HZ) for at_s in (MARKERS.stroke_start, MARKERS.stroke_end)
)


def wrists(played: Clip, side: str, *, curved: bool) -> FloatArray:
    """Where a wrist is (T, 3) in a gesture whose stroke leads .3 m outwards."""
    asked = replace(gesture("g", STROKE_S, 2.5, hand=played.hand), curved=curved)
    return wrist(moved(planned([asked], library(played))), side)


def added_m(played: Clip, side: str) -> FloatArray:
    """How far (T, 3) a wrist is from where it would be without the arc."""
    return wrists(played, side, curved=True) - wrists(played, side, curved=False)


@pytest.mark.parametrize("hand", Hand)
def test_the_wrist_is_beside_the_line_in_the_middle_of_the_stroke_and_in_its_place_at_both_ends(hand: Hand) -> None:
    for side in ("left", "right") if hand is Hand.BOTH else (hand,):
        way_m = wrists(clip(hand=hand), side, curved=False)[[BEGINS, ENDS]]
        beside_m = added_m(clip(hand=hand), side)
        length_m = float(np.linalg.norm(way_m[1] - way_m[0]))
        most = int(np.argmax(np.linalg.norm(beside_m, axis=1)))
        assert np.linalg.norm(beside_m[most]) == pytest.approx(ARC_SHARE * length_m, rel=0.2)
        assert abs(most - (BEGINS + ENDS) / 2) <= 0.25 * RATE_HZ * (MARKERS.stroke_end - MARKERS.stroke_start)
        assert beside_m[most, 1] > 0.5 * np.linalg.norm(beside_m[most]), "a stroke to the side goes over the line"
        assert abs(beside_m[most] @ (way_m[1] - way_m[0])) < 0.2 * length_m * np.linalg.norm(beside_m[most])


def test_nothing_is_bent_outside_the_stroke_nor_in_the_other_arm() -> None:
    beside_m = added_m(clip(), "right")
    np.testing.assert_allclose(np.vstack((beside_m[: BEGINS - 1], beside_m[ENDS + 2 :])), 0, atol=1e-9)
    np.testing.assert_allclose(added_m(clip(), "left"), 0, atol=1e-9)


def test_a_stroke_of_the_wrist_alone_and_one_that_is_an_arc_already_stay_as_they_are() -> None:
    in_place = clip(from_m=0.1, to_m=0.1)
    np.testing.assert_allclose(added_m(in_place, "right"), 0, atol=1e-9)
    arc = replace(clip(), tracks=(OffsetTrack(TrackForm.CURVED, "UpperArm", (0.0, 0.0, 10.0)),))
    np.testing.assert_allclose(added_m(arc, "right"), 0, atol=1e-9)
