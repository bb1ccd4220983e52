"""What the gazes aim at, before anything moves."""

import numpy as np
import pytest

from tests.support.motion.movements import behavior, schedule
from understudy.model import Channel
from understudy.realizer.head_and_gaze.gaze_targets import (
    AT_EASE,
    DIRECTIONS,
    HEAD_SHARE,
    LISTENER_M,
    LOWEST_HEAD,
    gaze_targets,
)

FROM_M = np.array([0.0, LISTENER_M[1], 0.0])


def degrees(*gazes: tuple[str, float, dict[str, object]]) -> list[tuple[float, list[float], list[float]]]:
    """When the aim changes, and the pitch and yaw of eyes and head then."""
    behaviors = (
        behavior(Channel.GAZE, lexeme, start_s, start_s + 0.1, start_s + 1.0, start_s + 1.1, **changes)
        for lexeme, start_s, changes in gazes
    )
    aims = gaze_targets(schedule(*behaviors), FROM_M, {"door": (1.0, LISTENER_M[1], 1.0)})
    eyes, head = np.degrees(aims.eyes[1:, :2]).tolist(), np.degrees(aims.head[1:]).tolist()
    return list(zip(aims.starts_s.tolist(), eyes, head, strict=True))


def test_before_the_first_gaze_all_is_on_the_listener() -> None:
    aims = gaze_targets(schedule(), FROM_M, {})
    assert len(aims.starts_s) == 0
    assert aims.eyes == pytest.approx(np.array([[0, 0, 1 / LISTENER_M[2]]]))


@pytest.mark.parametrize("direction", sorted(DIRECTIONS))
def test_a_direction_goes_its_angle_aside_and_back(direction: str) -> None:
    aside, back = degrees(("LOOK", 1.0, {"direction": direction, "amount": 0.25}))
    assert np.linalg.norm(aside[1]) == pytest.approx(15)
    assert aside[2] == pytest.approx(HEAD_SHARE["LOOK"] * np.array(aside[1]))
    assert (aside[1][0] < 0) == direction.startswith("UP")
    assert (aside[1][1] > 0) == direction.endswith("LEFT")
    assert back[0] == pytest.approx(2.0)
    assert back[1] == pytest.approx([0, 0])


def test_the_head_helps_eyes_that_would_be_strained() -> None:
    aside, _back = degrees(("GLANCE", 1.0, {"direction": "LEFT", "amount": 0.6}))
    assert aside[1] == pytest.approx([0, 36])
    assert aside[2] == pytest.approx([0, 36 - np.degrees(AT_EASE[1])])


def test_no_look_puts_the_chin_on_the_chest() -> None:
    """At the own feet the eyes look all the way down, the head does not go along."""
    looks = (behavior(Channel.GAZE, "LOOK", 1.0, 1.1, 2.0, 2.1, target=name) for name in ("feet", "ceiling"))
    aims = gaze_targets(schedule(*looks), FROM_M, {"feet": (0.0, 0.0, 0.4), "ceiling": (0.0, 4.0, 0.8)})
    assert np.degrees(aims.eyes[1, 0]) > 70
    assert aims.head[1, 0] == pytest.approx(LOWEST_HEAD["LOOK"])
    assert aims.head[2, 0] < -LOWEST_HEAD["LOOK"]


def test_a_moments_look_at_the_own_hand_is_the_eyes_more_than_the_heads() -> None:
    hand = {"hand": (0.0, 1.05, 0.35)}
    heads = []
    for lexeme in ("WATCH", "LOOK"):
        look = behavior(Channel.GAZE, lexeme, 1.0, 1.1, 2.0, 2.1, target="hand")
        aims = gaze_targets(schedule(look), FROM_M, hand)
        heads.append(float(np.degrees(aims.head[1, 0])))
        assert np.degrees(aims.eyes[1, 0]) > 40
    assert heads[0] == pytest.approx(25.0)
    assert heads[1] > 35


def test_of_two_gazes_the_later_one_has_the_eyes_until_it_ends() -> None:
    turned = degrees(("LOOK", 1.0, {"target": "door"}), ("LOOK", 1.5, {"direction": "RIGHT", "amount": 0.5}))
    assert [round(eyes[1]) for _start_s, eyes, _head in turned] == [45, -30, -30, 0]


def test_who_is_not_placed_is_where_the_listener_is() -> None:
    (shifted,) = degrees(("SHIFT", 1.0, {"target": "nobody knows"}))
    assert shifted[1] == pytest.approx([0, 0])
