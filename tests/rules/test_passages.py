"""Long lines are processed passage by passage: in time proportional to their length, with the same results as short
lines."""

from functools import partial

import pytest

from tests.support.operations import calls_of
from tests.support.shipped_rules import shipped_parser, shipped_rules
from tests.support.words.utterances import words_of
from understudy.model import Fact, Function, Parse, Utterance
from understudy.rules.chaining.facts import utterance_facts
from understudy.rules.derivation import derive_functions
from understudy.rules.passages import LONGEST_PASSAGE, by_passage, passage_starts

SLACK = 1.15


def _repeated(text: str, words: int) -> Utterance:
    """The text again and again, up to so many words."""
    listed = text.split()
    line = words_of(" ".join((listed * (words // len(listed) + 1))[:words]))
    return Utterance(line, shipped_parser().parse(line))


def _starts(text: str) -> list[int]:
    return passage_starts(utterance_facts(Utterance(words_of(text), Parse((), (), ()))))


def test_a_line_of_a_minute_is_one_passage_and_a_longer_one_is_cut_between_sentences() -> None:
    assert _starts("so it goes. " * (LONGEST_PASSAGE // 3)) == [0]
    assert _starts("and so it always goes. " * 61) == [0, 150, 300]
    assert _starts("and so it. " + "so it goes on. " * 40) == [0, 147]


def test_a_sentence_without_an_end_is_cut_where_a_passage_would_be_too_long() -> None:
    assert _starts("on " * (2 * LONGEST_PASSAGE + 1)) == [0, LONGEST_PASSAGE, 2 * LONGEST_PASSAGE]


def test_facts_go_where_they_begin_and_what_is_between_two_passages_is_in_both() -> None:
    inside, across, between = Fact("word", ("so", 4, 5)), Fact("clause", ("root", 4, 9, 5)), Fact("pause", (0.5, 6))
    line, table = Fact("utterance", (0, 9)), Fact("base_priority", ("negation", "plain", 2.0))
    assert by_passage([0, 6], (inside, across, between, line, table)) == [
        [inside, across, between, line, table],
        [between, line, table],
    ]


def test_a_sentence_does_the_same_in_any_passage() -> None:
    sentences = 50
    functions = derive_functions(shipped_rules(), _repeated("I do not know him. Do you?", 7 * sentences))

    def of(sentence: int) -> list[tuple[str, str, int, int]]:
        return sorted(_from(7 * sentence, each) for each in functions if each.first // 7 == sentence)

    assert all(of(sentence) == of(1) for sentence in range(2, sentences - 1))
    assert [each.id for each in functions] == [f"f{number}" for number in range(1, len(functions) + 1)]


def _from(first: int, function: Function) -> tuple[str, str, int, int]:
    return function.class_name, function.subtype, function.first - first, function.last - first


@pytest.mark.parametrize("text", ["the red house, the blue house,", "do you know who did it", "(the (very (old) man))"])
def test_a_line_of_twice_as_many_words_is_twice_the_work(text: str) -> None:
    half, whole = (calls_of(partial(derive_functions, shipped_rules(), _repeated(text, words))) for words in (300, 600))
    assert whole <= SLACK * 2 * half
