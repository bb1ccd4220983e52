"""A shrug is seen in the shoulders."""

import numpy as np
import pytest

from tests.support.motion.movements import BODY, TIMES_S, behavior, schedule
from understudy.model import Channel, FloatArray, Hand
from understudy.models import load_gestures
from understudy.realizer.body.limits import violations
from understudy.realizer.body.motion import BodyMotion
from understudy.realizer.body.movement_style import IdleLife
from understudy.realizer.body.skeleton import forward
from understudy.realizer.geometry.rotations import angle_between, rotate
from understudy.realizer.gestures.gesture_plan import GesturePlan
from understudy.realizer.scheduling.gesture_controller import apply_gestures
from understudy.realizer.scheduling.planning import plan_gestures
from understudy.realizer.torso.idle import idle_motion
from understudy.realizer.torso.shoulders_and_neck import LIFTS_DEG, with_neck_reaching, with_shrugs

LIBRARY = load_gestures()


def planned(lexeme: str, hand: Hand) -> GesturePlan:
    asked = behavior(Channel.GESTURE, lexeme, 1.2, 1.5, 1.5, 1.9, 1.9, 2.6, 3.1, hand=hand, amount=0.5)
    return plan_gestures(LIBRARY, schedule(asked), seed=0)


def before_and_after(lexeme: str, hand: Hand = Hand.BOTH) -> tuple[BodyMotion, BodyMotion]:
    plan = planned(lexeme, hand)
    body = apply_gestures(BODY, idle_motion(BODY, TIMES_S, schedule(), seed=1), plan, seed=1)
    return body, with_shrugs(BODY, body, plan)


def elevation_deg(body: BodyMotion, side: str) -> FloatArray:
    """Of the collarbone over the level of the upper chest (T,)."""
    places_m, turned = forward(BODY, body.rotations, body.hips_m)
    shoulder, arm, chest = BODY.chain(f"{side}Shoulder", f"{side}UpperArm", "upperChest")
    way = places_m[:, arm] - places_m[:, shoulder]
    up = np.array([[0.0, 1.0, 0.0]])

    sines = np.sum(way * rotate(turned[:, chest], up), axis=1) / np.linalg.norm(way, axis=1)
    return np.asarray(np.degrees(np.arcsin(sines)))


@pytest.mark.parametrize(("lexeme", "hand"), [("SHRUG", Hand.BOTH), ("UNCERTAINTY", Hand.BOTH), ("SHRUG", Hand.RIGHT)])
def test_both_shoulders_go_up_by_eight_degrees_for_three_tenths_of_a_second(lexeme: str, hand: Hand) -> None:
    before, after = before_and_after(lexeme, hand)
    for side in ("left", "right"):
        lift = elevation_deg(after, side) - elevation_deg(before, side)
        assert np.count_nonzero(lift >= 8) / 60 >= 0.3, side
        assert lift[TIMES_S < 1.0].max() == pytest.approx(0, abs=1e-6)
        assert lift[-1] == pytest.approx(0, abs=1e-6)
    assert np.all(violations(BODY, after.rotations) <= violations(BODY, before.rotations) + 1e-9)


def test_the_arms_rise_with_the_shoulders_and_keep_their_orientation() -> None:
    before, after = before_and_after("SHRUG")
    (places_m, turned), (raised_m, kept) = (forward(BODY, each.rotations, each.hips_m) for each in (before, after))
    hands = BODY.chain("leftHand", "rightHand", "leftUpperArm", "rightUpperArm")
    assert angle_between(turned[:, hands], kept[:, hands]).max() < 1e-6
    rise_m = (raised_m - places_m)[:, hands, 1].max(axis=0)
    assert np.all((rise_m > 0.012) & (rise_m < 0.06))


def test_other_gestures_leave_the_shoulders_alone() -> None:
    assert set(LIFTS_DEG) <= set(LIBRARY.categories)
    before, after = before_and_after("OPEN_HAND", Hand.RIGHT)
    assert after is before


LIFE = IdleLife(neck_forward_deg=10.0)


def test_the_head_comes_forward_and_down_and_keeps_its_orientation() -> None:
    before = idle_motion(BODY, TIMES_S, schedule(), seed=1)
    after = with_neck_reaching(BODY, before, schedule(), np.zeros(len(TIMES_S)), seed=1, life=LIFE)
    head = BODY.index["head"]
    (before_m, before_turned), (after_m, after_turned) = (
        forward(BODY, each.rotations, each.hips_m) for each in (before, after)
    )
    assert angle_between(before_turned[:, head], after_turned[:, head]).max() < 1e-6
    moved_m = (after_m - before_m)[:, head]
    assert moved_m[:, 2].mean() == pytest.approx(0.1 * np.sin(np.radians(10)), abs=0.004)
    assert moved_m[:, 1].max() < 0


def test_strokes_move_it_too() -> None:
    before = idle_motion(BODY, TIMES_S, schedule(), seed=1)
    strokes = np.radians(np.where(TIMES_S > 1.0, 6.0, 0.0))
    after = with_neck_reaching(BODY, before, schedule(), strokes, seed=1, life=IdleLife())
    turned = np.degrees(angle_between(before.rotations, after.rotations)[:, BODY.index["neck"]])
    assert turned == pytest.approx(np.degrees(strokes), abs=1e-6)
