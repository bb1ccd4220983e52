"""Hands by their directions: fingers and palm where they are to be, the twist in the forearm, all within limits."""

import numpy as np
from scipy.spatial.transform import Rotation

from understudy.model import FloatArray
from understudy.realizer.geometry.rotations import IDENTITY, multiply, rotate
from understudy.realizer.gestures.wrist_angles import HIGHEST_DEG, LOWEST_DEG, preserving_wrist_angles, wrist_angles

FOREARMS: FloatArray = Rotation.random(200, random_state=4).as_quat()
UP, AWAY = np.array([0.0, 1.0, 0.0]), np.array([0.0, 0.0, 1.0])
FINGERS, PALM = np.array([1.0, 0.0, 0.0]), np.array([0.0, -1.0, 0.0])


def test_fingers_and_palm_point_where_they_are_to_before_limits_are_kept() -> None:
    turn = wrist_angles(FOREARMS, UP, AWAY)
    hand = multiply(multiply(FOREARMS, turn.forearm), turn.hand)
    assert np.allclose(rotate(hand, FINGERS), UP)
    assert np.allclose(rotate(hand, PALM), AWAY)


def test_only_the_forearm_twists_and_only_the_hand_bends() -> None:
    turn = wrist_angles(FOREARMS, UP, AWAY)
    assert np.allclose(turn.forearm[:, 1:3], 0)
    assert np.allclose(turn.hand[:, 0], 0)


def test_what_is_not_said_is_as_the_forearm_has_it() -> None:
    assert np.allclose(wrist_angles(FOREARMS, None, None).angles, 0)
    only_palm = wrist_angles(FOREARMS, None, AWAY)
    assert np.allclose(only_palm.hand, IDENTITY)
    only_fingers = wrist_angles(FOREARMS, UP, None)
    assert np.allclose(only_fingers.angles[:, 0], 0)
    assert np.allclose(rotate(multiply(FOREARMS, only_fingers.hand), FINGERS), UP, atol=1e-6)


def test_clamping_keeps_the_limits_and_tells_what_was_over() -> None:
    turn = wrist_angles(FOREARMS, UP, AWAY)
    within = np.degrees(turn.clamped().angles)
    assert np.all(within >= LOWEST_DEG - 1e-9)
    assert np.all(within <= HIGHEST_DEG + 1e-9)
    assert np.allclose(turn.excess, np.abs(turn.angles - turn.clamped().angles))
    assert turn.clamped().excess.max() == 0


def test_a_hand_is_kept_as_it_is_by_the_turn_that_says_so() -> None:
    hands = Rotation.random(200, random_state=5).as_quat()
    turn = preserving_wrist_angles(FOREARMS, hands)
    again = multiply(multiply(FOREARMS, turn.forearm), turn.hand)
    assert np.allclose(np.abs(np.sum(again * hands, axis=-1)), 1.0)
