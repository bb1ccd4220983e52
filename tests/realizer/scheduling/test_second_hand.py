"""What the other hand does: it follows part of the way, hangs, or stays; and two hands are no mirror images."""

from dataclasses import replace

import numpy as np
import pytest

from tests.support.motion.gesture_clips import HandMade, clip, gesture, library, place
from understudy.model import Behavior, Channel, Hand, Schedule, SyncPoints
from understudy.realizer.arms.arm_keys import arm_track
from understudy.realizer.arms.wrist_paths import relax_m
from understudy.realizer.body.movement_style import MovementStyle, SecondHand, TwoHands
from understudy.realizer.body.skeleton import Skeleton
from understudy.realizer.geometry.rotations import angle_between
from understudy.realizer.gestures.gesture import ArmKey
from understudy.realizer.gestures.gesture_plan import GesturePlan
from understudy.realizer.scheduling.planning import plan_gestures
from understudy.realizer.scheduling.rests import rest_m

SKELETON = Skeleton.standing()
ALWAYS = MovementStyle(second_hand=SecondHand(follows=1.0, share=(0.4, 0.4), lag_s=(0.1, 0.1)))
RARELY = MovementStyle(second_hand=SecondHand(follows=1e-9, share=(0.4, 0.4), lag_s=(0.1, 0.1)))
UNLIKE = MovementStyle(two_hands=TwoHands(lag_s=(0.08, 0.08), smaller=(0.15, 0.15), bend_deg=9.0))
ONE_OR_BOTH = library(clip(), clip("left", hand=Hand.LEFT), clip("both", hand=Hand.BOTH))


def planned(
    *behaviors: Behavior, style: MovementStyle, clips: HandMade = ONE_OR_BOTH, leading: Hand = Hand.RIGHT
) -> GesturePlan:
    return plan_gestures(clips, Schedule(behaviors, 9.0), seed=0, style=style, leading=leading)


def test_the_other_hand_follows_part_of_the_way_and_later() -> None:
    plan = planned(gesture("g1", 2.0, 2.6), style=ALWAYS)
    (arm,), (other,) = plan.gestures, plan.following
    assert (arm.side, other.side) == (Hand.RIGHT, Hand.LEFT)
    assert other.markers.stroke == pytest.approx(2.1)
    assert other.markers.relax == pytest.approx(2.6)
    hanging_m = rest_m("at_side", Hand.LEFT)
    way_m = relax_m(arm.placed, Hand.RIGHT) - hanging_m
    assert relax_m(other.placed, Hand.LEFT) - hanging_m == pytest.approx(0.4 * way_m)


def test_what_only_follows_is_not_told_as_played() -> None:
    alone, followed = (planned(gesture("g1", 2.0, 2.6), style=style) for style in (MovementStyle(), ALWAYS))
    assert followed.realized == alone.realized
    assert followed.decisions == alone.decisions
    assert followed.units == alone.units


def test_a_hand_that_follows_is_relaxed() -> None:
    plan = planned(gesture("g1", 2.0, 2.6), style=ALWAYS)
    keys = arm_track(SKELETON, Hand.LEFT, plan).keys
    for key in keys:
        assert np.nanmax(angle_between(key.pose.parts[5:], keys[0].pose.parts[5:])) < 1e-6


def test_a_hand_whose_partner_leaves_the_clasp_hangs_or_follows_and_is_never_alone_there() -> None:
    behaviors = gesture("g1", 2.0, 2.5, hand=Hand.BOTH), gesture("g2", 5.0, 5.5)
    for style in (ALWAYS, RARELY):
        plan = planned(*behaviors, style=style)
        (other,) = (each for each in plan.following if each.behavior == "g2")
        clasped = [rest for rest in plan.rests if rest.side is Hand.LEFT and rest.pose == "clasped"]
        assert all(rest.end_s <= other.markers.start or rest.start_s >= other.markers.end for rest in clasped)
    assert other.placed.share == 0.0


def test_a_hand_at_the_side_stays_there_where_it_does_not_follow() -> None:
    assert planned(gesture("g1", 2.0, 2.6), style=RARELY).following == ()


def test_a_hand_that_has_its_own_gesture_too_soon_does_not_follow() -> None:
    """The right hand strikes from 1.7 to 2.2 s, the left one from 2.3 s."""
    plan = planned(gesture("g1", 2.0, 2.4), gesture("g2", 2.6, 3.0, hand=Hand.LEFT), style=ALWAYS)
    assert [(each.behavior, each.side) for each in plan.following if each.behavior == "g1"] == []


def test_a_hand_in_a_posture_of_both_stays_in_it() -> None:
    behind = Behavior("p1", Channel.POSTURE, "HANDS_BEHIND_BACK", SyncPoints(0.2, 0.9, ready=0.9), 0, 0, 1.0)
    plan = planned(behind, gesture("g1", 4.0, 4.6), style=ALWAYS)
    assert plan.following == ()


def test_the_hand_that_does_not_lead_is_later_smaller_and_has_other_fingers() -> None:
    plan = planned(gesture("g1", 2.0, 3.0, hand=Hand.BOTH), style=UNLIKE)
    arms = {arm.side: arm for arm in plan.gestures}
    right, left = arms[Hand.RIGHT], arms[Hand.LEFT]
    assert left.markers.stroke - right.markers.stroke == pytest.approx(0.08)
    assert left.placed.size == pytest.approx(0.85 * right.placed.size)
    assert right.placed.bends_deg == ()
    assert 0 < np.ptp(left.placed.bends_deg) <= 1.3 * 9
    assert plan.realized["g1"].stroke == 2.0


def test_a_left_hander_leads_with_the_left() -> None:
    """The clip's right hand goes .3 m out, its left one nowhere: who leads with the left makes it the other way
    round."""
    one = clip("both", hand=Hand.BOTH)
    uneven = replace(one, keys=tuple(replace(key, left=ArmKey(place=place(0.0))) for key in one.keys))
    out_m = {}
    for leading in (Hand.LEFT, Hand.RIGHT):
        behavior = gesture("g1", 2.0, 3.0, hand=Hand.BOTH)
        plan = planned(behavior, style=UNLIKE, clips=library(uneven), leading=leading)
        first = min(plan.gestures, key=lambda arm: arm.markers.stroke)
        assert first.side is leading
        out_m[leading] = relax_m(first.placed, leading)
    assert out_m[Hand.LEFT] == pytest.approx(out_m[Hand.RIGHT])


def test_what_is_drawn_for_a_gesture_does_not_depend_on_the_others() -> None:
    style = MovementStyle(second_hand=SecondHand(follows=1.0, share=(0.3, 0.5), lag_s=(0.05, 0.2)))
    alone = planned(gesture("g2", 6.0, 6.5), style=style)
    both = planned(gesture("g1", 2.0, 2.5), gesture("g2", 6.0, 6.5), style=style)
    assert alone.following[-1].placed == both.following[-1].placed
    assert both.following[0].placed.share != both.following[1].placed.share


def reaching(up_m: float) -> HandMade:
    """A library of one gesture whose stroke ends that much above the middle of gesture space."""
    one = clip()
    keys = tuple(replace(key, right=ArmKey(place=place(up_m=up_m))) for key in one.keys)
    return library(replace(one, keys=keys))


def test_a_hand_that_follows_one_overhead_stays_before_the_body() -> None:
    """Two fifths of the way to a hand over the head would lift the elbow to the shoulder."""
    (other,) = planned(gesture("g1", 2.0, 2.6), style=ALWAYS, clips=reaching(0.7)).following
    (chest,) = planned(gesture("g1", 2.0, 2.6), style=ALWAYS, clips=reaching(0.1)).following
    assert chest.placed.share == pytest.approx(0.4)
    assert other.placed.share < 0.3


def test_a_hand_that_follows_one_below_goes_down_with_it() -> None:
    belly = replace(ALWAYS, second_hand=replace(ALWAYS.second_hand, near_belly=True))
    (low,) = planned(gesture("g1", 2.0, 2.6), style=belly, clips=reaching(-0.35)).following
    (chest,) = planned(gesture("g1", 2.0, 2.6), style=belly, clips=reaching(0.1)).following
    assert low.placed.basis == "at_side" != chest.placed.basis
