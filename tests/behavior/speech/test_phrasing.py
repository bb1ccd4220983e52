"""The phrases and stresses of a line, with hand-made words of .4 s with a vowel in their second half."""

from dataclasses import replace

import pytest

from tests.support.words.by_hand import spoken
from understudy.behavior.speech.phrasing import emphases_s, phrases
from understudy.model import Interval, Word


def later(words: tuple[Word, ...], first: int, delay_s: float) -> tuple[Word, ...]:
    """The words with a pause before word `first`."""
    return tuple(
        replace(word, interval=Interval(word.interval.start_s + delay_s, word.interval.end_s + delay_s))
        if word.index >= first and word.interval
        else word
        for word in words
    )


def test_a_phrase_ends_at_a_pause_or_with_a_sentence() -> None:
    words = later(spoken("one two three. Four five", start_s=0.0), 4, 0.3)
    assert [(round(p.start_s, 3), round(p.end_s, 3)) for p in phrases(words)] == [(0, 1.2), (1.2, 1.6), (1.9, 2.3)]


@pytest.mark.parametrize(("pause_s", "count"), [(0.19, 1), (0.21, 2)])
def test_a_pause_of_a_fifth_of_a_second_parts_phrases(pause_s: float, count: int) -> None:
    assert len(phrases(later(spoken("one two"), 1, pause_s))) == count


def test_without_times_there_are_no_phrases() -> None:
    assert phrases((Word(0, "one"),)) == ()


def test_emphases_lie_where_the_vowels_of_emphasised_words_begin() -> None:
    words = spoken("one two three", start_s=0.0, stressed=(0, 2))
    words = (words[0], replace(words[1], stressed_ratio=0.9, prominence=0.9), words[2])
    assert emphases_s(words) == pytest.approx((0.2, 1.0))
