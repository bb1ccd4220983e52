"""The plan on the body: hands where the clips say, at the time they say, and no corner on the way."""

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
from understudy.realizer.body.skeleton import Skeleton, forward
from understudy.realizer.geometry.rotations import IDENTITY, angle_between
from understudy.realizer.gestures.arm_joints import arm_joints
from understudy.realizer.gestures.gesture import ArmKey, Clip, ClipKey, FrameType, OffsetTrack, TrackForm
from understudy.realizer.gestures.gesture_plan import GesturePlan
from understudy.realizer.scheduling.gesture_controller import ARC, apply_gestures
from understudy.realizer.scheduling.planning import plan_gestures

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
        assert np.linalg.norm(beside_m[most]) == pytest.approx(ARC * length_m, rel=0.2)
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
