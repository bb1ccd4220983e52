"""Postures last until the next, and move by minimum jerk between the times that the schedule gives."""

import numpy as np
import pytest

from tests.support.motion.movements import TIMES_S, behavior
from understudy.model import Behavior, Channel
from understudy.realizer.torso.posture import POSTURES, SHORTEST_SHIFT_S, trunk_postures


def shift(lexeme: str, start_s: float, end_s: float, amount: float | None = None) -> Behavior:
    return behavior(Channel.POSTURE, lexeme, start_s, end_s, amount=amount)


def test_a_lean_begins_at_its_start_is_there_at_its_end_and_lasts() -> None:
    held = trunk_postures(TIMES_S, [shift("LEAN_FORWARD", 1.0, 2.0)], weight=0.3)
    forward = np.degrees(held.forward)
    assert forward[TIMES_S <= 1.0] == pytest.approx(0)
    assert forward[TIMES_S >= 2.0] == pytest.approx(POSTURES["LEAN_FORWARD"].forward_degrees)
    assert held.weight == pytest.approx(0.3)


def test_another_posture_takes_the_place_of_the_one_before() -> None:
    shifts = [shift("LEAN_LEFT", 0.5, 1.2), shift("WEIGHT_ON_RIGHT_LEG", 2, 3), shift("STRAIGHTEN", 4, 5)]
    held = trunk_postures(TIMES_S, reversed(shifts), weight=0.0)
    at = np.searchsorted(TIMES_S, [0.0, 1.5, 3.5, 5.5])
    assert np.degrees(held.left[at]) == pytest.approx([0, 6, 0, 0])
    assert held.weight[at] == pytest.approx([0, 0.5, -1, 0])


def test_a_posture_that_is_no_shift_comes_back_to_the_latest_shift() -> None:
    lean = behavior(Channel.POSTURE, "LEAN_FORWARD", 2.0, 2.7, 4.0, 4.7)
    held = trunk_postures(TIMES_S, [shift("LEAN_LEFT", 0.5, 1.2), lean], weight=0.0)
    at = np.searchsorted(TIMES_S, [1.5, 3.0, 4.0, 5.0])
    assert np.degrees(held.forward[at]) == pytest.approx([0, 9, 9, 0])
    assert np.degrees(held.left[at]) == pytest.approx([6, 0, 0, 6])


def test_a_shift_of_no_time_takes_its_time_and_a_small_one_goes_less_far() -> None:
    held = trunk_postures(TIMES_S, [shift("LEAN_FORWARD", 1.0, 1.0, 0.5)], weight=0.0)
    assert 0 < held.forward[np.searchsorted(TIMES_S, 1.0 + SHORTEST_SHIFT_S / 2)] < held.forward[-1]
    assert np.degrees(held.forward[-1]) == pytest.approx(4.5)


def test_what_lost_and_where_the_hands_rest_moves_no_trunk() -> None:
    lost = behavior(Channel.POSTURE, "LEAN_LEFT", 1.0, 2.0, kept=False)
    held = trunk_postures(TIMES_S, [lost, shift("HANDS_FOLDED", 1.0, 2.0)], weight=0.2)
    assert not held.left.any()
    assert held.weight == pytest.approx(0.2)
