"""Where hands rest, and how long the ways there take."""

from dataclasses import replace

import pytest

from understudy.model import Behavior, Channel, Hand, Schedule, SyncPoints
from understudy.realizer.arms.wrist_paths import distance_m
from understudy.realizer.scheduling.rests import (
    PREPARATION_SPEED_M_S,
    SHORTEST_PREPARATION_S,
    posture_changes,
    posture_pose,
    preparation_s,
    rest_m,
    rest_pose_for_gap,
    rest_way_m,
)


def posture(lexeme: str, start_s: float) -> Behavior:
    return Behavior(f"p{start_s}", Channel.POSTURE, lexeme, SyncPoints(start_s, start_s + 0.7), 0, 0, 1.0)


@pytest.mark.parametrize(
    ("gap_s", "pose"), [(2.99, "clasped"), (3.0, "at_side"), (9.99, "at_side"), (10.0, "in_pockets")]
)
def test_the_pose_suits_the_gap(gap_s: float, pose: str) -> None:
    assert rest_pose_for_gap(gap_s) == pose


def test_postures_of_the_hands_last_until_the_next_or_a_change_of_leg() -> None:
    behaviors = (
        posture("WEIGHT_ON_LEFT_LEG", 9.0),
        posture("HANDS_FOLDED", 2.0),
        posture("LEAN_FORWARD", 4.0),
        posture("HANDS_ON_HIPS", 6.0),
    )
    changes = posture_changes(Schedule(behaviors, 12.0))
    assert [posture_pose(changes, time_s) for time_s in (1.0, 2.0, 5.0, 7.0, 10.0)] == [
        None,
        "folded",
        "folded",
        "on_hips",
        None,
    ]


def test_a_posture_that_comes_back_leaves_the_hands_as_the_latest_shift_did() -> None:
    passing = replace(posture("HANDS_ON_HIPS", 5.0), sync=SyncPoints(5.0, 8.0, ready=5.6, relax=7.4))
    changes = posture_changes(Schedule((posture("HANDS_FOLDED", 2.0), passing), 12.0))
    assert [posture_pose(changes, time_s) for time_s in (3.0, 6.0, 7.5)] == ["folded", "on_hips", "folded"]


def test_a_posture_of_the_first_moment_is_how_the_line_begins() -> None:
    assert posture_changes(Schedule((posture("HANDS_FOLDED", 0.4),), 3.0)) == ((0.0, "folded"),)


def test_a_preparation_takes_the_clips_time_or_what_the_way_needs() -> None:
    assert preparation_s(0.1, 0.2) == SHORTEST_PREPARATION_S
    assert preparation_s(0.1, 0.9) == 0.9
    assert preparation_s(0.6, 0.2) == pytest.approx(0.6 / PREPARATION_SPEED_M_S)


def test_hands_at_the_sides_hang_lower_and_farther_out_than_clasped() -> None:
    for side in (Hand.LEFT, Hand.RIGHT):
        out_m, up_m, _away = rest_m("at_side", side) - rest_m("clasped", side)
        assert out_m > 0.1
        assert up_m < -0.1


def test_the_way_behind_the_back_is_longer_than_through_the_body() -> None:
    before_m = rest_m("clasped", Hand.LEFT)
    assert rest_way_m("clasped", Hand.LEFT, before_m) == 0.0
    for side in (Hand.LEFT, Hand.RIGHT):
        straight_m = distance_m(rest_m("behind_back", side), before_m)
        round_m = rest_way_m("behind_back", side, before_m)
        assert round_m > straight_m
        assert round_m == pytest.approx(
            rest_way_m("at_side", side, rest_m("behind_back", side)) + rest_way_m("at_side", side, before_m)
        )
