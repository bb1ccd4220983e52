"""Strokes repeated on further emphases."""

import pytest

from tests.support.gesture_clips import clip, gesture
from understudy.model import Schedule
from understudy.realizer.gestures.gesture import Expressivity
from understudy.realizer.gestures.gesture_plan import PlacedGesture
from understudy.realizer.scheduling.repetition import most_repeats, with_repeats
from understudy.realizer.scheduling.selection import place_clip, requests_of


def struck(category: str = "BEAT", repetition: float = 0.0) -> PlacedGesture:
    """Stroke end at 2.2 s, relax at 2.5 s."""
    (request,) = requests_of(Schedule((gesture("g", 2.0, 2.5, lexeme=category),), 30.0))
    return place_clip(clip(category=category, expressivity=Expressivity(repetition=repetition)), request)


@pytest.mark.parametrize(
    ("emphases_s", "until_s", "ends_s"),
    [
        ([], 9.0, []),
        ([2.0, 2.2, 2.5], 9.0, []),
        ([2.6], 9.0, [2.6]),
        ([3.0, 2.6], 9.0, [2.6, 3.0]),
        ([2.6, 2.8, 3.0], 9.0, [2.6, 3.0]),
        ([2.6, 3.0, 3.4], 9.0, [2.6, 3.0]),
        ([2.6, 3.0], 2.9, [2.6]),
        ([3.8], 9.0, []),
        ([2.6, 4.2], 9.0, [2.6]),
    ],
)
def test_emphases_count_that_are_neither_too_soon_nor_too_late(
    emphases_s: list[float], until_s: float, ends_s: list[float]
) -> None:
    repeats = with_repeats(struck(), emphases_s, until_s).repeats
    assert [repeat.end_s for repeat in repeats] == ends_s
    assert [repeat.amplitude for repeat in repeats] == [0.6, 0.4][: len(ends_s)]
    assert all(repeat.start_s < repeat.end_s for repeat in repeats)


def test_the_hold_follows_the_last_repetition() -> None:
    assert with_repeats(struck(), [2.6], 9.0).relax_s == pytest.approx(2.7)
    assert with_repeats(struck(), [], 9.0).relax_s == 2.5
    assert with_repeats(struck(), [2.6], 2.65).relax_s == 2.65


@pytest.mark.parametrize(
    ("category", "repetition", "most"),
    [("GREETING", 0.0, 0), ("GREETING", 0.4, 1), ("GREETING", 1.0, 3), ("BEAT", 0.0, 2), ("BEAT", 1.0, 3)],
)
def test_how_often_is_the_expressivitys_to_say(category: str, repetition: float, most: int) -> None:
    assert most_repeats(struck(category, repetition)) == most
