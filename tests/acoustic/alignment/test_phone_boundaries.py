"""Words become boundaries and boundaries words, with nothing lost between."""

import numpy as np

from understudy.acoustic.alignment.phone_boundaries import (
    SHORTEST_PAUSE_S,
    Boundary,
    boundaries,
    spaced_times,
    with_boundaries,
)
from understudy.model import Interval, Phone, Word


def _word(index: int, *phones: tuple[str, float, float]) -> Word:
    made = tuple(Phone(label, Interval(start_s, end_s)) for label, start_s, end_s in phones)
    return Word(index, "word", Interval(made[0].interval.start_s, made[-1].interval.end_s), made)


WORDS = (_word(0, ("S", 0.2, 0.3), ("AA", 0.3, 0.5)), _word(1, ("M", 0.5, 0.6)), _word(2, ("T", 0.8, 0.9)))


def test_phones_that_touch_share_a_boundary_and_pauses_have_two() -> None:
    assert boundaries(WORDS) == [
        Boundary(0.2, None, "S"),
        Boundary(0.3, "S", "AA"),
        Boundary(0.5, "AA", "M"),
        Boundary(0.6, "M", None),
        Boundary(0.8, None, "T"),
        Boundary(0.9, "T", None),
    ]


def test_a_gap_shorter_than_a_pause_is_none() -> None:
    for gap_s, count in ((SHORTEST_PAUSE_S - 0.001, 3), (SHORTEST_PAUSE_S + 0.001, 4)):
        words = (_word(0, ("M", 1.0, 1.1)), _word(1, ("T", 1.1 + gap_s, 1.3)))
        assert len(boundaries(words)) == count


def test_words_are_rebuilt_as_they_were_and_between_other_times() -> None:
    times_s = np.array([boundary.time_s for boundary in boundaries(WORDS)])
    assert with_boundaries(WORDS, times_s) == WORDS
    later = with_boundaries(WORDS, times_s + np.arange(6.0))
    assert [word.interval for word in later] == [Interval(0.2, 2.5), Interval(2.5, 3.6), Interval(4.8, 5.9)]
    assert later[0].phones[1].interval == Interval(1.3, 2.5)


def test_times_that_crossed_are_put_in_order() -> None:
    assert spaced_times(np.array([0.5, 0.4, 0.9]), 1.0).tolist() == [0.5, 0.51, 0.9]
    assert spaced_times(np.array([-0.1, 0.995, 1.4]), 1.0).tolist() == [0.0, 0.99, 1.0]
