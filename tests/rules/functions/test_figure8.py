"""The paper's Figure 8 from its text: the words, the stress the figure shows, and the functions it draws from them."""

from dataclasses import replace

import pytest

from tests.support.shipped_rules import shipped_parser, shipped_rules
from tests.support.words.utterances import words_of
from understudy.acoustic.stress import Measure, with_emphasis
from understudy.model import Function, Utterance
from understudy.rules.derivation import derive_functions

LINE = "I guess not, I think I must've misread all of those signals."
STRESSED = {1: 0.23, 10: 0.42}
"""The two words that pass the threshold in the figure (its W2 and W11), with ratios of ours; the rest stay under .1."""


@pytest.fixture(scope="module")
def functions() -> tuple[Function, ...]:
    words = tuple(replace(word, stressed_ratio=STRESSED.get(word.index, 0.05)) for word in words_of(LINE))
    words = with_emphasis(words, Measure())
    return derive_functions(shipped_rules(), Utterance(words, shipped_parser().parse(words)))


@pytest.mark.parametrize(
    ("class_name", "subtype", "first", "last"),
    [
        ("deixis", "self", 0, 0),
        ("deixis", "self", 3, 3),
        ("deixis", "self", 5, 5),
        ("negation", "plain", 2, 2),
        ("deixis", "distal", 10, 10),
        ("deixis", "distal", 10, 11),
        ("initial_noun_phrase", "plain", 0, 0),
        ("initial_verb_phrase", "plain", 1, 1),
        ("emphasis", "plain", 1, 1),
        ("emphasis", "plain", 10, 10),
    ],
)
def test_the_functions_of_the_figure_are_found_and_kept(
    functions: tuple[Function, ...], class_name: str, subtype: str, first: int, last: int
) -> None:
    found = [one for one in functions if (one.class_name, one.subtype) == (class_name, subtype)]
    assert (first, last, True) in [(one.first, one.last, one.kept) for one in found]


def test_all_is_a_quantity(functions: tuple[Function, ...]) -> None:
    quantities = [one for one in functions if one.class_name == "quantification" and one.kept]
    assert [(one.first, one.subtype) for one in quantities] == [(8, "all")]


def test_only_the_stressed_words_are_emphasised(functions: tuple[Function, ...]) -> None:
    assert [one.first for one in functions if one.class_name == "emphasis"] == [1, 10]


def test_the_joined_pointing_outranks_its_determiner_and_rests_on_it(functions: tuple[Function, ...]) -> None:
    alone, joined = (one for one in functions if (one.class_name, one.subtype) == ("deixis", "distal"))
    assert joined.priority > alone.priority
    assert f"fcn(deixis, distal, {alone.first}, {alone.last + 1})" in [because.fact for because in joined.because]
    assert alone.first in [because.word for because in joined.because]


def test_stress_raises_what_begins_or_ends_on_it(functions: tuple[Function, ...]) -> None:
    priorities = {(one.class_name, one.first, one.last): one.priority for one in functions}
    assert priorities["initial_verb_phrase", 1, 1] > priorities["initial_noun_phrase", 0, 0]
    assert priorities["deixis", 10, 10] > priorities["deixis", 0, 0]
