from itertools import combinations, pairwise, product

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from understudy.behavior.reading.strokes import (
    NEAR,
    PLACE,
    PRECISE,
    SHARE_POWER,
    STROKES_APART_S,
    UNPLACED,
    WHOLE,
    WINDOWS,
    Worth,
    strokes,
    windowed,
)
from understudy.behavior.reading.word_times import usual_times_s
from understudy.model import SingleArray

PRICE = 0.4


def column(*values: float) -> SingleArray:
    return np.array(values, np.float32).reshape(-1, 1)


def unplaced(*values: float) -> Worth:
    """What one gesture is worth on each word, of which the reading knows no place."""
    return Worth(column(*values), column(*[0.0] * len(values)), np.zeros(len(values), np.float32))


def placed(*at_word: float) -> Worth:
    """One gesture that is wanted on some words, and therefore worth as much near them."""
    at = column(*at_word)
    return Worth(np.clip(windowed(at, WHOLE), 0, 1), at, np.zeros(len(at_word), np.float32))


def taken(worth: Worth, **options: list[int]) -> list[int]:
    """The strokes at the usual times of words: four words apart."""
    return [each.word for each in strokes(worth, PRICE, usual_times_s(len(worth.stroke)), **options)]


def test_nothing_is_taken_that_costs_more_than_it_gains() -> None:
    assert taken(unplaced(0.1, 0.39, 0.2)) == []
    assert taken(unplaced()) == []


def test_of_two_that_are_too_near_the_better_is_taken() -> None:
    assert taken(unplaced(0.5, 0.1, 0.9, 0.1, 0.1, 0.1, 0.6)) == [2, 6]


def test_two_good_ones_beat_a_better_one_between_them() -> None:
    assert taken(unplaced(0.8, 0.1, 0.9, 0.1, 0.8)) == [0, 4]


def test_no_stroke_falls_where_the_hands_are_to_be_still() -> None:
    assert taken(unplaced(0.2, 0.9, 0.2), still=[1]) == []


def test_what_is_named_once_is_shown_once_and_on_its_word() -> None:
    """Two strokes would fit, one before and one after the word, and each would be worth as much."""
    assert taken(placed(0, 0, 0.9, 0, 0)) == [2]


def test_what_is_named_twice_is_shown_twice() -> None:
    assert taken(placed(0.9, 0, 0, 0, 0.9)) == [0, 4]


def test_a_stroke_between_two_others_has_what_they_leave() -> None:
    worth = placed(0.5, 0, 0.25, 0.25, 0)
    share = worth.share((0, NEAR))[2, 0]
    assert share == pytest.approx(((0.5 + UNPLACED) / (1.0 + UNPLACED)) ** SHARE_POWER)
    assert worth.share(WHOLE)[2, 0] == 1.0


TIMES_S = [0.0, 0.4, 0.6, 1.1, 1.45, 1.7, 2.9, 3.0, 3.2]


@given(st.lists(st.tuples(st.floats(0, 1, width=32), st.floats(0, 1, width=32)), min_size=1, max_size=7))
def test_the_strokes_are_the_best_of_all_that_are_possible(values: list[tuple[float, float]]) -> None:
    whole, at_word = zip(*values, strict=True)
    worth = Worth(column(*whole), column(*at_word), np.zeros(len(values), np.float32))
    gains = {window: worth.gains(window) - PRICE for window in WINDOWS}

    def total(words: tuple[int, ...]) -> float:
        """The most that strokes on these words gain, with windows that do not overlap."""
        gaps = [later - earlier - 1 for earlier, later in pairwise(words)]
        shared = [[(right, min(NEAR, gap - right)) for right in range(min(NEAR, gap) + 1)] for gap in gaps]
        return max(
            sum(
                float(gains[left, right][word])
                for word, left, right in zip(
                    words, (NEAR, *(each[1] for each in split)), (*(each[0] for each in split), NEAR), strict=True
                )
            )
            for split in product(*shared)
        )

    legal = [
        words
        for count in range(1, len(values) + 1)
        for words in combinations(range(len(values)), count)
        if all(TIMES_S[later] - TIMES_S[earlier] >= STROKES_APART_S for earlier, later in pairwise(words))
    ]
    best = max([0.0, *(total(words) for words in legal)])
    found = strokes(worth, PRICE, TIMES_S[: len(values)])
    words = tuple(each.word for each in found)
    assert (words in legal) or not words
    assert sum(float(gains[each.window][each.word]) for each in found) == pytest.approx(best, abs=1e-4)


def test_slow_words_have_room_for_more_strokes_and_quick_ones_for_fewer() -> None:
    worth = unplaced(*[0.9] * 9)
    counts = [len(strokes(worth, PRICE, [word * word_s for word in range(9)])) for word_s in (0.15, 0.3, 0.6)]
    assert counts == [2, 3, 5]


def test_a_long_recording_has_thousands_of_strokes() -> None:
    words = 10_000
    found = strokes(unplaced(*[0.9] * words), PRICE, usual_times_s(words))
    assert len(found) == words / 4


def test_a_window_reaches_over_words_to_both_sides() -> None:
    assert windowed(column(0, 0, 1, 0, 0, 0), (1, 1))[:, 0].tolist() == [0, 1, 1, 1, 0, 0]
    assert windowed(column(0, 0, 1, 0, 0, 0), (0, 2))[:, 0].tolist() == [1, 1, 1, 0, 0, 0]


def test_a_gain_counts_the_word_itself_and_likely_strokes_beside_the_worth() -> None:
    found = Worth(column(0.5, 0.5), column(1, 0), np.array([0.0, 0.2], np.float32)).gains()
    assert found == pytest.approx([0.5 + PRECISE + PLACE * 0.2, 0.5 + PLACE * 0.2])
