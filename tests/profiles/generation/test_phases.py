"""Which gestures are one unit."""

import random
from dataclasses import replace

import pytest

from tests.support.words.scripted import habit, profile
from understudy.model import Interval
from understudy.profiles.generation.phases import TimedStrokes, joined
from understudy.profiles.profile import Profile, UnitHabit


def _sizes(speaker: Profile, starts_s: list[float]) -> list[int]:
    strokes = [TimedStrokes((Interval(start_s, start_s + 0.3),), held=False) for start_s in starts_s]
    sizes: list[int] = []
    for is_joined in joined(speaker, strokes, [0] * len(strokes), random.Random(0)):
        sizes[-1:] = [sizes[-1] + 1] if is_joined else [*sizes[-1:], 1]
    return sizes


@pytest.mark.parametrize(
    ("shares", "sizes"),
    [((1.0,), [6]), ((0.0,), [1, 1, 1, 1, 1, 1]), ((1.0, 0.0), [2, 2, 2]), ((1.0, 1.0, 0.0), [3, 3])],
)
def test_how_often_neighbours_are_joined_depends_on_the_size_of_the_unit(
    shares: tuple[float, ...], sizes: list[int]
) -> None:
    speaker = replace(profile({"A": habit(1.0)}, {"any": {"A": 0.5}}), units=UnitHabit(1.5, shares, ()))
    assert _sizes(speaker, [1.0 + 1.4 * number for number in range(6)]) == sizes  # 1.1 s apart


def test_gestures_without_time_to_rest_are_one_unit_of_any_size() -> None:
    speaker = replace(profile({"A": habit(1.0)}, {"any": {"A": 0.5}}), units=UnitHabit(1.5, (0.0,), ()))
    assert _sizes(speaker, [1.0, 1.9, 2.8, 5.0]) == [3, 1]  # .6 s apart, then 1.9
