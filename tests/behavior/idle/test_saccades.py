import random
from collections import Counter

import pytest

from understudy.behavior.idle.idle_behaviors import (
    DIRECTIONS,
    LISTENING,
    NARROWEST_DEGREES,
    TALKING,
    Glance,
    Habit,
    glances,
)
from understudy.model import Interval

LONG = Interval(10.0, 20_010.0)


def seen(habit: Habit, free: Interval = LONG) -> list[Glance]:
    return list(glances(free, habit, random.Random(1)))


@pytest.mark.parametrize("habit", [TALKING, LISTENING])
def test_the_eyes_are_on_the_other_for_their_share_of_the_time(habit: Habit) -> None:
    aside_s = sum(glance.interval.duration_s for glance in seen(habit))
    assert 1 - aside_s / LONG.duration_s == pytest.approx(habit.eye_contact, abs=0.04)


def test_directions_and_angles_are_those_measured() -> None:
    found = seen(TALKING)
    counts = Counter(glance.direction for glance in found)
    for direction, percent in DIRECTIONS.items():
        assert 100 * counts[direction] / len(found) == pytest.approx(percent, abs=2)
    angles = [glance.angle_degrees for glance in found]
    assert min(angles) >= NARROWEST_DEGREES
    assert max(angles) <= TALKING.widest_degrees


def test_glances_stay_in_their_time_and_apart() -> None:
    found = seen(TALKING, Interval(3.0, 60.0))
    ends_s = [3.0, *(glance.interval.end_s for glance in found)]
    assert all(end_s < glance.interval.start_s for end_s, glance in zip(ends_s, found, strict=False))
    assert ends_s[-1] <= 60.0
