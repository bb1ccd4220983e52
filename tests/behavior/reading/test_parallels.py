"""Phrases that answer one another are placed."""

import numpy as np
import pytest

from understudy.behavior.reading.contrasts import Ground
from understudy.behavior.reading.decoding import usual_times_s
from understudy.behavior.reading.parallels import parallel_strokes
from understudy.library.language import find_functions
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
