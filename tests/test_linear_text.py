"""What reads the words as they are written takes time in proportion to them, however they are made: twice the text is
at most twice the work, counted in operations. The regular expressions on the way have no choice to go back on."""

from collections.abc import Callable
from functools import partial

import pytest

from tests.support.operations import operations_of
from understudy.model import Parse, Utterance
from understudy.rules.chaining.facts import normalized_word, utterance_facts
from understudy.syntax.parser import sentence_starts
from understudy.text.transcript import MAX_WRITTEN_CHARACTERS, read_transcript

SLACK = 1.1
NOTHING = Parse((), (), ())


def _read(text: str) -> None:
    words = read_transcript(text)
    utterance_facts(Utterance(words=words, parse=NOTHING))
    sentence_starts(words)


@pytest.mark.parametrize(
    "make",
    [
        lambda n: "a" + "!" * n + "b",
        lambda n: "no" + "!" * (n // 2) + '"' * (n // 2) + "x",
        lambda n: "N" + "\u0301" * n + "o",
        lambda n: "No" + "." * (n // 2) + '"' * (n // 2),
        lambda n: "'" * n,
        lambda n: "&" * n,
        lambda n: "-" * n + "a" + "…" * 3,
    ],
)
def test_twice_as_long_a_word_is_twice_the_work(make: Callable[[int], str]) -> None:
    half, whole = (operations_of(partial(_read, make(n))) for n in (450, 900))
    assert whole <= SLACK * 2 * half


@pytest.mark.parametrize("word", ["no", '"a"', '"a', "a...", "a-a", "I.", "?", "N\u0301o"])
def test_twice_as_many_words_are_twice_the_work(word: str) -> None:
    half, whole = (operations_of(partial(_read, f"{word} " * n)) for n in (200, 400))
    assert whole <= SLACK * 2 * half


def test_a_word_without_its_punctuation_is_the_same_as_ever() -> None:
    for text, word in {
        "No!": "no",
        "“Don’t!”": "don't",
        "'em,": "'em",
        "dogs'": "dogs",
        "$5.50.": "$5.50",
        "50%…": "50%",
        "(R&B)": "r&b",
        "—": "",
        "'": "",
        "_": "_",
        "a" + "!" * MAX_WRITTEN_CHARACTERS + "b": "a" + "!" * MAX_WRITTEN_CHARACTERS + "b",
    }.items():
        assert normalized_word(text) == word
