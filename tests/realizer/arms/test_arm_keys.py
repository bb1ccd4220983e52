"""Keys of a plan on the clock."""

from dataclasses import replace

import numpy as np
import pytest

from tests.support.motion.gesture_clips import clip, gesture, library, place
from understudy.model import Behavior, Hand, Schedule
from understudy.realizer.arms.arm_keys import HOLD_NOISE, arm_track
from understudy.realizer.arms.interpolation import TimedPose
from understudy.realizer.arms.posing import pose_arm, wrist_of
from understudy.realizer.arms.rest_poses import rest_pose
from understudy.realizer.body.skeleton import Skeleton
from understudy.realizer.geometry.rotations import angle_between
from understudy.realizer.gestures.gesture import (
    ArmKey,
    Clip,
    ClipKey,
    Expressivity,
    FrameType,
    HandForm,
    HandShape,
    KeyCurve,
)
from understudy.realizer.gestures.gesture_plan import Repeat
from understudy.realizer.scheduling.planning import plan_gestures

SKELETON = Skeleton.standing()


def keys_of(one: Clip, *behaviors: Behavior, side: Hand = Hand.RIGHT) -> tuple[TimedPose, ...]:
    plan = plan_gestures(library(one), Schedule(behaviors, 9.0), seed=0)
    return arm_track(SKELETON, side, plan).keys


def with_keys(*keys: tuple[float, FrameType]) -> Clip:
    """The usual clip and further keys in it."""
    usual = clip()
    more = (ClipKey(time_s, kind, None, ArmKey(place=place(0.1, 0.1))) for time_s, kind in keys)
    return replace(usual, keys=tuple(sorted((*usual.keys, *more), key=lambda key: key.time_s)))


def test_phases_stretch_and_strokes_do_not() -> None:
    """Rest, halfway through the preparation of .4 s that takes longer here, ready, the stroke of .5 s and a pose .1 s
    after its start, the hold to 3.2 s, halfway back, rest."""
    one = with_keys(
        (0.2, FrameType.PREPARATION),
        (0.4, FrameType.READY),
        (0.6, FrameType.STROKE),
        (1.1, FrameType.HOLD),
        (1.4, FrameType.RETRACTION),
    )
    asked = gesture("g1", 2.0, 3.2)
    asked = replace(asked, sync=replace(asked.sync, start=1.1))
    plan = plan_gestures(library(one), Schedule((asked,), 9.0), seed=0)
    (markers,) = (arm.markers for arm in plan.gestures)
    halfway_s, back_s = (markers.start + markers.ready) / 2, (markers.relax + markers.end) / 2
    times_s = [key.time_s for key in arm_track(SKELETON, Hand.RIGHT, plan).keys]
    expected = [markers.start, halfway_s, 1.6, 1.7, 1.8, 2.2, 2.7, 3.2, back_s, markers.end]
    assert times_s[1:-1] == pytest.approx(expected)


def test_a_blend_plays_neither_retraction_nor_preparation() -> None:
    one = with_keys((0.2, FrameType.PREPARATION), (1.4, FrameType.RETRACTION))
    times_s = [key.time_s for key in keys_of(one, gesture("g1", 2.0, 2.5), gesture("g2", 3.3, 3.8))]
    assert [time_s for time_s in times_s if 2.3 < time_s < 3.1] == pytest.approx([2.5, 3.0])


def test_a_hold_has_one_pose_and_stirs() -> None:
    held = [key for key in keys_of(clip(), gesture("g1", 2.0, 3.2)) if 2.1 < key.time_s < 3.3]
    assert [key.time_s for key in held] == pytest.approx([2.2, 3.2])
    assert [key.noise for key in held] == [HOLD_NOISE, HOLD_NOISE]
    end = pose_arm(SKELETON, Hand.RIGHT, ArmKey(place=place(0.3)))
    for key in held:
        assert np.nanmax(angle_between(key.pose.parts, end.parts)) < 1e-6


def test_an_idle_arm_only_rests() -> None:
    poses = [key.pose.parts for key in keys_of(clip(), gesture("g1", 2.0, 3.2), side=Hand.LEFT)]
    at_side = rest_pose(SKELETON, Hand.LEFT, "at_side").as_partial().parts
    for pose in poses:
        assert angle_between(pose, at_side).max() < 1e-6


def test_a_hand_underway_is_raised_in_the_first_frame() -> None:
    resting, raised = (keys_of(clip(), gesture("g1", stroke_s, stroke_s + 1))[0] for stroke_s in (2.0, 0.35))
    start = pose_arm(SKELETON, Hand.RIGHT, ArmKey(place=place(0.0)))
    said = start.defined
    from_rest = angle_between(resting.pose.parts[said], start.parts[said]).max()
    assert angle_between(raised.pose.parts[said], start.parts[said]).max() < 0.6 * from_rest


@pytest.mark.parametrize(
    ("expressivity", "tension", "bias"),
    [
        (Expressivity(fluidity=1.0, power=0.5), (-0.5, 0.0), 0.0),
        (Expressivity(fluidity=0.5, power=1.0), (0.0, 0.5), 0.25),
    ],
)
def test_fluidity_and_power_shape_the_curve(
    expressivity: Expressivity, tension: tuple[float, float], bias: float
) -> None:
    start, end = [key for key in keys_of(clip(expressivity=expressivity), gesture("g1", 2.0, 3.2)) if key.marked]
    assert (start.tension, end.tension) == tension
    assert end.bias == bias


def test_what_a_frame_says_of_the_curve_takes_the_place_of_expressivity() -> None:
    usual = clip(expressivity=Expressivity(fluidity=0.0, power=1.0))
    start, end = usual.keys
    said = replace(usual, keys=(start, replace(end, curve=KeyCurve(tension=-0.2, continuity=0.4))))
    first, last = [key for key in keys_of(said, gesture("g1", 2.0, 3.2)) if key.marked]
    assert (first.tension, first.continuity, first.bias) == (0.5, 0.0, 0.0)
    assert (last.tension, last.continuity, last.bias) == (-0.2, 0.4, 0.25)


def test_fingers_of_a_hand_that_does_not_lead_are_bent_differently() -> None:
    shaped = replace(clip(), keys=tuple(_with_hand(key) for key in clip().keys))
    plan = plan_gestures(library(shaped), Schedule((gesture("g1", 2.0, 3.2),), 9.0), seed=0)
    (arm,) = plan.gestures
    bends_deg = (9.0, 3.0, -2.0, 6.0)
    bent = replace(plan, gestures=(replace(arm, placed=replace(arm.placed, bends_deg=bends_deg)),))
    before, after = (arm_track(SKELETON, Hand.RIGHT, each).keys[2].pose.parts for each in (plan, bent))
    turned = np.degrees(angle_between(before, after))
    assert np.nanmax(turned[:8]) < 1e-6
    assert turned[8:] == pytest.approx(np.abs(np.repeat(bends_deg, 3)), abs=1e-6)


def _with_hand(key: ClipKey) -> ClipKey:
    return replace(key, right=replace(key.right or ArmKey(), hand=HandShape(HandForm.FLAT)))


def test_a_beat_in_a_hold_goes_back_by_its_way_towards_hanging() -> None:
    plan = plan_gestures(library(clip()), Schedule((gesture("g1", 2.0, 4.2),), 9.0), seed=0)
    (arm,) = plan.gestures
    beating = replace(plan, gestures=(replace(arm, beats=(Repeat(2.6, 3.2, 0.0, way_m=0.2),)),))
    keys = {round(key.time_s, 3): key.pose for key in arm_track(SKELETON, Hand.RIGHT, beating).keys}
    held, back = (wrist_of(SKELETON, Hand.RIGHT, keys[time_s].parts) for time_s in (2.6, 2.9))
    assert np.linalg.norm(held - back) == pytest.approx(0.2, rel=0.25)
    assert back[1] < held[1] - 0.1
