"""Gestures drawn: their poses, and the speed of the hand through them."""

from dataclasses import replace

import numpy as np
import pytest

from tests.support.motion.gesture_clips import clip, place
from understudy.model import Hand
from understudy.realizer.body.skeleton import Skeleton
from understudy.realizer.gestures.gesture import ArmKey, Clip, ClipKey, FrameType, KeyCurve
from understudy.realizer.pictures.gesture_sheet import alone, draw_gestures, wrist_speeds_m_s

SKELETON = Skeleton.standing()
EMPHASIS_S = 0.75
"""The middle of the usual clip's stroke, by which it has come half its way."""


def through(curve: KeyCurve, hand: Hand = Hand.RIGHT) -> Clip:
    """The usual clip, with a pose in the middle of its stroke."""
    usual = clip(hand=hand)
    arm = ArmKey(place=place(0.15))
    left, right = (arm if side in {hand, Hand.BOTH} else None for side in (Hand.LEFT, Hand.RIGHT))
    middle = ClipKey(EMPHASIS_S, FrameType.STROKE, left, right, curve=curve)
    return replace(usual, keys=tuple(sorted((*usual.keys, middle), key=lambda key: key.time_s)))


def speed_m_s(curve: KeyCurve) -> float:
    """Of the wrist as it passes the pose."""
    plan = alone(through(curve))
    times_s, speeds = wrist_speeds_m_s(SKELETON, plan)
    passed_s = plan.gestures[0].placed.offset_s + EMPHASIS_S
    return float(np.interp(passed_s, times_s, speeds[Hand.RIGHT]))


def test_tension_slows_the_hand_at_the_pose_and_its_opposite_speeds_it_up() -> None:
    """It does not quite stop: muscles smooth a stop over some hundredths of a second."""
    slack, usual, tense = (speed_m_s(KeyCurve(tension=tension)) for tension in (-0.8, 0.0, 1.0))
    assert slack > 1.2 * usual
    assert tense < 0.5 * usual


@pytest.mark.parametrize("hand", [Hand.LEFT, Hand.BOTH])
def test_the_hands_that_gesture_are_drawn(hand: Hand) -> None:
    _times_s, speeds = wrist_speeds_m_s(SKELETON, alone(through(KeyCurve(), hand)))
    assert set(speeds) == ({Hand.LEFT, Hand.RIGHT} if hand is Hand.BOTH else {hand})


def test_the_picture_has_the_poses_of_all_clips() -> None:
    picture, poses = draw_gestures(SKELETON, [through(KeyCurve(bias=0.5)), clip("other")])
    assert picture.startswith(b"\x89PNG")
    assert poses == 5
