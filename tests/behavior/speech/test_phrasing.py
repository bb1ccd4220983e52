"""The phrases and stresses of a line, with hand-made words of .4 s with a vowel in their second half."""

from dataclasses import replace

import pytest

from tests.support.motion.gesture_clips import gesture
from tests.support.words.by_hand import function, spoken
from understudy.behavior.speech.phrasing import emphases_s, expanded_in_rhemes, phrases
from understudy.model import Function, Interval, Word


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


RHEME = replace(function("information", "rheme", 1, 4), given=True)


@pytest.mark.parametrize(
    ("function", "asked_s"),
    [
        (RHEME, (0.7, 1.5)),
        (replace(RHEME, last=2), (0.7,)),
        (replace(RHEME, first=3), None),
        (replace(RHEME, given=False), None),
        (replace(RHEME, subtype="theme"), None),
    ],
)
def test_a_gesture_in_a_rheme_strikes_again_on_its_later_emphases(
    function: Function, asked_s: tuple[float, ...] | None
) -> None:
    """Vowels of the emphasised words 0, 1, 2 and 4 begin at .2, .6, 1.0 and 1.8 s; the stroke ends at .3 s, on the
    second word."""
    words = spoken("one two three four five six", start_s=0.0, stressed=(0, 1, 2, 4))
    struck = gesture("g", 0.1, 0.5)
    struck = replace(struck, first=1, last=1, sync=replace(struck.sync, stroke_end=0.3))
    (found,) = expanded_in_rhemes([struck], words, [function])
    assert found.after_strokes_s == (asked_s and pytest.approx(asked_s))
