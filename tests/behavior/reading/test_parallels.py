"""Phrases that answer one another are placed."""

import numpy as np
import pytest

from understudy.behavior.reading.parallels import Ground, PlacedStroke, parallel_strokes, placed_strokes, with_placed
from understudy.behavior.reading.word_times import usual_times_s
from understudy.library.language import find_functions
from understudy.model import Function, SingleArray
from understudy.models import Understudy


def placed(understudy: Understudy, text: str, word_s: float = 0.5, contrast: float = 0.3) -> list[tuple[str, str]]:
    utterance = find_functions(understudy.language, text).utterance
    count = len(utterance.words)
    times_s = [time_s * word_s / 0.3 for time_s in usual_times_s(count)]
    ground = Ground(times_s, np.zeros(count, np.float32))
    strokes = parallel_strokes(utterance, ground, np.full(count, contrast, np.float32))
    return [(utterance.words[each.word].text.strip(",."), each.side) for each in strokes]


def test_each_of_two_things_that_change_places_keeps_its_side(understudy: Understudy) -> None:
    line = "Ask not what your country can do for you, ask what you can do for your country."
    sides = [("country", "left"), ("you", "right"), ("you", "right"), ("country", "left")]
    assert placed(understudy, line) == sides
    assert placed(understudy, line, contrast=0.0) == sides


def test_what_differs_is_set_side_by_side(understudy: Understudy) -> None:
    line = "We shall fight on the beaches, we shall fight on the hills."
    assert placed(understudy, line) == [("beaches", "left"), ("hills", "right")]


def test_what_differs_is_not_placed_where_nothing_is_read_as_a_contrast(understudy: Understudy) -> None:
    assert placed(understudy, "We shall fight on the beaches, we shall fight on the hills.", contrast=0.1) == []


def test_strokes_too_close_in_time_are_left_out(understudy: Understudy) -> None:
    line = "We shall fight on the beaches, we shall fight on the hills."
    assert placed(understudy, line, word_s=0.1) == [("beaches", "left")]


@pytest.mark.parametrize(
    "line", ["I went to the shop, and then it rained all day.", "Yes, yes, of course.", "He came, he saw, he left."]
)
def test_other_phrases_are_no_parallels(understudy: Understudy, line: str) -> None:
    assert placed(understudy, line) == []


def locus(first: int, last: int, side: str, *, kept: bool = True) -> Function:
    return Function(f"f{first}", "locus", side, first, last, 3.0, "mention_that_is_placed", kept=kept)


def row(*values: float) -> SingleArray:
    return np.array(values, np.float32)


def ground(gain: SingleArray, still: tuple[int, ...] = ()) -> Ground:
    return Ground(usual_times_s(len(gain)), gain, still)


SEVEN = row(0, 0, 0.5, 0, 0, 0, 0.5)
"""He is RICH but she is POOR."""
HE, SHE = locus(0, 0, "left"), locus(4, 4, "right")


def test_each_side_gets_a_stroke_where_most_is_gained_in_or_right_after_its_mention() -> None:
    found = list(placed_strokes([HE, SHE], SEVEN, ground(SEVEN)))
    assert found == [PlacedStroke(2, "left", 6), PlacedStroke(6, "right", 2)]


def test_one_side_worth_a_contrast_is_enough_for_both() -> None:
    assert len(list(placed_strokes([HE, SHE], row(0, 0, 0, 0, 0, 0, 0.5), ground(SEVEN)))) == 2
    assert not list(placed_strokes([HE, SHE], row(*[0.1] * 7), ground(SEVEN)))


def test_sides_too_near_for_two_strokes_are_left_to_one_gesture() -> None:
    you, me = locus(0, 0, "left"), locus(2, 2, "right")
    assert not list(placed_strokes([you, me], row(1, 1, 1), ground(row(1, 1, 1))))


def test_a_side_of_which_every_word_is_to_be_still_is_not_shown() -> None:
    assert not list(placed_strokes([HE, SHE], SEVEN, ground(SEVEN, (4, 5, 6))))


def test_two_mentions_to_one_side_and_lost_ones_are_no_pair() -> None:
    assert not list(placed_strokes([HE, locus(4, 4, "left")], SEVEN, ground(SEVEN)))
    assert not list(placed_strokes([HE, locus(4, 4, "right", kept=False)], SEVEN, ground(SEVEN)))


def test_of_three_places_the_third_begins_a_new_pair() -> None:
    gain = row(*[0.5] * 20)
    loci = [locus(0, 0, "left"), locus(6, 6, "right"), locus(12, 12, "left"), locus(18, 18, "right")]
    assert [each.side for each in placed_strokes(loci, gain, ground(gain))] == ["left", "right"] * 2


def test_strokes_near_a_placed_one_give_way() -> None:
    placed = [PlacedStroke(2, "left", 8), PlacedStroke(8, "right", 2)]
    assert with_placed([2, 5, 12], placed, ground(row(*[0.5] * 13))) == [2, 8, 12]
