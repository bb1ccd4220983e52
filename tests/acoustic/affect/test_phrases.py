"""Phrases end at pauses, unless what they would leave is too short."""

import pytest

from understudy.acoustic.affect.phrases import phrase_interval, phrases_of
from understudy.model import Interval, Word


def words(*spans: tuple[float, float] | None) -> tuple[Word, ...]:
    return tuple(Word(index, "so", span and Interval(*span)) for index, span in enumerate(spans))


@pytest.mark.parametrize(
    ("spans", "phrases"),
    [
        ((), ()),
        ((None,), ()),
        (((0.0, 0.5), (0.5, 1.0)), ((0, 1),)),
        (((0.0, 0.7), (1.0, 1.7)), ((0, 0), (1, 1))),
        (((0.0, 0.7), (0.9, 1.7)), ((0, 1),)),
        (((0.0, 0.2), (1.0, 1.7)), ((0, 1),)),
        (((0.0, 0.7), (1.0, 1.2)), ((0, 1),)),
        ((None, (0.0, 0.7), None, (1.0, 1.7)), ((0, 2), (3, 3))),
    ],
    ids=["nothing", "untimed", "no pause", "a pause", "a closure", "short before", "short after", "unspoken words"],
)
def test_pauses_divide(spans: tuple[tuple[float, float] | None, ...], phrases: tuple[tuple[int, int], ...]) -> None:
    assert phrases_of(words(*spans)) == phrases


def test_a_phrase_reaches_from_first_to_last_timed_word() -> None:
    assert phrase_interval(words(None, (0.2, 0.7), (0.7, 1.0), None), 0, 3) == Interval(0.2, 1.0)
