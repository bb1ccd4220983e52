"""A pointing arm is on the line to its target, also where the trunk leans."""

import numpy as np
import pytest

from tests.support.motion.movements import BODY, TIMES_S, behavior, schedule
from understudy.model import Channel, FloatArray, Hand, Schedule, Target
from understudy.models import load_gestures, load_realizer
from understudy.realizer.body.limits import violations
from understudy.realizer.body.motion import BodyMotion, Motion
from understudy.realizer.body.movement_style import IdleLife
from understudy.realizer.body.skeleton import Skeleton, forward
from understudy.realizer.geometry.rotations import angle_between, from_axis_angle, inverse, rotate
from understudy.realizer.gestures.gesture_plan import GesturePlan
from understudy.realizer.realizing import realize
from understudy.realizer.scheduling.gesture_controller import apply_gestures
from understudy.realizer.scheduling.planning import plan_gestures
from understudy.realizer.torso.idle import idle_motion
from understudy.realizer.torso.upper_body import (
    LIFTS_DEG,
    with_hands_on_pelvis,
    with_hanging_arms,
    with_neck_reaching,
    with_shrugs,
)

LAMP = Target("lamp", (1.0, 1.5, 1.9))
POINTING = behavior(Channel.GESTURE, "POINT_LEFT", 1.2, 1.7, 1.7, 2.0, 2.1, 3.2, 3.8, hand=Hand.LEFT, target="lamp")


def off_line_deg(skeleton: Skeleton, motion: Motion, at_s: float) -> float:
    """The angle at the shoulder between the left wrist and the lamp."""
    frame = round(at_s * motion.frame_rate_hz)
    places_m, _turned = forward(skeleton, motion.body.rotations[frame], motion.body.hips_m[frame])
    shoulder_m, wrist_m = (places_m[joint] for joint in skeleton.chain("leftUpperArm", "leftHand"))
    hand, way = wrist_m - shoulder_m, np.array(LAMP.position_m) - shoulder_m
    return float(np.degrees(np.arccos(unit(hand) @ unit(way))))


def unit(vector: FloatArray) -> FloatArray:
    return np.asarray(vector / np.linalg.norm(vector))


@pytest.mark.parametrize("lean", ["LEAN_LEFT", "LEAN_RIGHT", "LEAN_BACK"])
def test_an_arm_points_at_its_target_while_the_body_leans(lean: str) -> None:
    realizer = load_realizer()
    leaning = behavior(Channel.POSTURE, lean, 0.3, 1.0, 4.0, 4.8)
    motion = realize(realizer, Schedule((POINTING, leaning), 6.0, targets=(LAMP,)))
    stroke_end_s = motion.realized[POINTING.id].stroke_end
    assert stroke_end_s is not None
    assert off_line_deg(realizer.skeleton, motion, stroke_end_s) < 13


LEANING = idle_motion(BODY, TIMES_S, schedule(behavior(Channel.POSTURE, "LEAN_LEFT", 1.0, 2.0)), seed=4)


def aside_deg(body: BodyMotion, side: str) -> FloatArray:
    """Of the upper arm from straight down, in the frontal plane (T,)."""
    places_m = forward(BODY, body.rotations, body.hips_m)[0]
    arm, elbow = BODY.chain(f"{side}UpperArm", f"{side}LowerArm")
    way = places_m[:, elbow] - places_m[:, arm]
    return np.degrees(np.arctan2(way[:, 0], -way[:, 1]))


def test_hanging_arms_stay_as_they_hang_while_the_trunk_leans() -> None:
    straight = with_hanging_arms(BODY, LEANING.copy())
    before, after = TIMES_S < 0.9, TIMES_S > 2.2
    for side in ("left", "right"):
        swings = [
            abs(aside_deg(body, side)[after].mean() - aside_deg(body, side)[before].mean())
            for body in (LEANING, straight)
        ]
        assert swings[0] > 3
        assert swings[1] < 0.5 * swings[0]


def test_a_raised_arm_goes_with_the_ribs() -> None:
    rotations = LEANING.rotations.copy()
    rotations[:, BODY.index["leftUpperArm"]] = from_axis_angle((0.0, 0.0, 1.0), np.array(0.2))
    raised = BodyMotion(TIMES_S, rotations, LEANING.hips_m)
    arm = BODY.index["leftUpperArm"]
    assert np.allclose(with_hanging_arms(BODY, raised.copy()).rotations[:, arm], rotations[:, arm], atol=1e-9)


def strayed_m(body: BodyMotion, side: str) -> float:
    """How far a wrist goes about in the space of the pelvis, after the hands have come to rest."""
    places_m, turned = forward(BODY, body.rotations, body.hips_m)
    hips, wrist = BODY.chain("hips", f"{side}Hand")
    there_m = rotate(inverse(turned[:, hips]), places_m[:, wrist] - places_m[:, hips])[TIMES_S > 0.5]
    return float(np.linalg.norm(there_m - there_m[0], axis=1).max())


@pytest.mark.parametrize("posture", ["HANDS_ON_HIPS", "HANDS_IN_POCKETS"])
def test_hands_on_the_pelvis_stay_there_while_the_ribs_lean(posture: str) -> None:
    resting = behavior(Channel.POSTURE, posture, 0.0, 0.2)
    plan = plan_gestures(LIBRARY, schedule(resting), seed=0)
    body = apply_gestures(BODY, LEANING.copy(), plan, seed=0, noise_scale=0.0)
    carried = with_hands_on_pelvis(BODY, body.copy(), plan)
    for side in ("left", "right"):
        assert strayed_m(body, side) > 0.02
        assert strayed_m(carried, side) < 0.5 * strayed_m(body, side)


def test_hands_before_the_belly_go_with_the_ribs() -> None:
    plan = plan_gestures(LIBRARY, schedule(behavior(Channel.POSTURE, "HANDS_CLASPED", 0.0, 0.2)), seed=0)
    body = apply_gestures(BODY, LEANING.copy(), plan, seed=0)
    assert with_hands_on_pelvis(BODY, body, plan) is body


LIBRARY = load_gestures()


def planned(lexeme: str, hand: Hand) -> GesturePlan:
    asked = behavior(Channel.GESTURE, lexeme, 1.2, 1.5, 1.5, 1.9, 1.9, 2.6, 3.1, hand=hand, amount=0.5)
    return plan_gestures(LIBRARY, schedule(asked), seed=0)


def before_and_after(lexeme: str, hand: Hand = Hand.BOTH) -> tuple[BodyMotion, BodyMotion]:
    plan = planned(lexeme, hand)
    body = apply_gestures(BODY, idle_motion(BODY, TIMES_S, schedule(), seed=1), plan, seed=1)
    return body, with_shrugs(BODY, body.copy(), plan)


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
    assert np.array_equal(after.rotations, before.rotations)


LIFE = IdleLife(neck_forward_deg=10.0)


def test_the_head_comes_forward_and_down_and_keeps_its_orientation() -> None:
    before = idle_motion(BODY, TIMES_S, schedule(), seed=1)
    after = with_neck_reaching(BODY, before.copy(), schedule(), np.zeros(len(TIMES_S)), seed=1, life=LIFE)
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
    after = with_neck_reaching(BODY, before.copy(), schedule(), strokes, seed=1, life=IdleLife())
    turned = np.degrees(angle_between(before.rotations, after.rotations)[:, BODY.index["neck"]])
    assert turned == pytest.approx(np.degrees(strokes), abs=1e-6)
