"""Where the sentences of a line begin."""

import pytest

from understudy.model import Interval, Word
from understudy.syntax.sentences import LONG_PAUSE_S, sentence_starts


@pytest.mark.parametrize(
    ("text", "starts"),
    [
        ("Hello there", {0}),
        ("Hello. How are you? Fine!", {0, 1, 4}),
        ("“Stop!” he said.", {0, 1}),
        ("I saw Dr. Who and J. Smith. They left.", {0, 7}),
        ("No. I mean it.", {0, 1}),
        ("well... maybe not", {0}),
        ("Well... Maybe not", {0, 1}),
        ("I know… “Maybe not", {0, 2}),
        ("yeah. i know", {0, 1}),
        ("Hello . How are you", {0, 2}),
    ],
)
def test_sentences_begin_after_marks_that_end_one(text: str, starts: set[int]) -> None:
    assert sentence_starts(tuple(Word(index, word) for index, word in enumerate(text.split()))) == starts


def _spoken(text: str, pause_after: int, pause_s: float) -> tuple[Word, ...]:
    words, now_s = [], 0.0
    for index, word in enumerate(text.split()):
        words.append(Word(index, word, Interval(now_s, now_s + 0.25)))
        now_s += 0.25 + (pause_s if index == pause_after else 0.0)
    return tuple(words)


def test_an_unpunctuated_line_is_cut_at_long_pauses_alone() -> None:
    assert sentence_starts(_spoken("yeah right i guess so", 1, LONG_PAUSE_S)) == {0, 2}
    assert sentence_starts(_spoken("yeah right i guess so", 1, LONG_PAUSE_S / 2)) == {0}


def test_a_pause_in_a_punctuated_line_is_a_hesitation() -> None:
    assert sentence_starts(_spoken("Yeah, right, I guess so.", 1, 2 * LONG_PAUSE_S)) == {0}


def test_no_words_have_no_sentences() -> None:
    assert sentence_starts(()) == frozenset()
