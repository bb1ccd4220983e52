"""The common scale of both measures of stress, and the words that are emphasised by it in the shipped rules."""

from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.support.shipped_rules import shipped_rules
from tests.support.words.utterances import utterance, words_of
from understudy.acoustic.stress.emphasis import Measure, with_emphasis
from understudy.model import EMPHASISED, Utterance, Word
from understudy.rules.derivation import derive_functions


def heard(ratio: float | None, prominence: float | None) -> Word:
    return Word(0, "so", stressed_ratio=ratio, prominence=prominence)


def emphasis(measure: Measure, ratio: float | None, prominence: float | None) -> float | None:
    return with_emphasis((heard(ratio, prominence),), measure)[0].emphasis


@pytest.mark.parametrize(
    ("measure", "expected"),
    [
        (Measure(above_prominence=0.4), [False, True]),
        (Measure(above_prominence=0.35), [True, True]),
        (Measure("ratio"), [True, False]),
        (Measure("ratio", above_ratio=0.0), [True, True]),
        (Measure("ratio", above_ratio=1.0), [False, False]),
    ],
)
def test_words_are_emphasised_above_the_threshold_of_the_measure_that_is_set(
    measure: Measure, expected: list[bool]
) -> None:
    words = with_emphasis((heard(0.2, 0.4), heard(0.1, 0.41)), measure)
    assert [word.is_emphasised for word in words] == expected


def test_a_word_without_prominence_is_judged_by_its_ratio_and_one_not_heard_not_at_all() -> None:
    assert emphasis(Measure(), 0.3, None) == emphasis(Measure("ratio"), 0.3, 0.9)
    assert emphasis(Measure(), None, None) is None


def test_both_measures_have_their_ends_and_their_thresholds_in_common() -> None:
    for value, expected in ((0.0, 0.0), (0.4, EMPHASISED), (1.0, 1.0)):
        assert emphasis(Measure(above_prominence=0.4), 0.0, value) == expected
        assert emphasis(Measure("ratio", above_ratio=0.4), value, 0.0) == expected


@given(st.floats(0, 1), st.floats(0, 1), st.floats(0, 1))
def test_a_word_that_stands_out_more_has_no_less_emphasis(threshold: float, one: float, other: float) -> None:
    lower, higher = (emphasis(Measure(above_prominence=threshold), 0.0, value) or 0.0 for value in sorted((one, other)))
    assert 0 <= lower <= higher <= 1


def test_the_shipped_rules_emphasise_the_emphasised() -> None:
    words = (replace(word, emphasis=value) for word, value in zip(words_of("so it is"), (0.5, 0.501, 1.0), strict=True))
    functions = derive_functions(shipped_rules(), Utterance(tuple(words), utterance("", "").parse))
    assert [found.first for found in functions if found.class_name == "emphasis"] == [1, 2]
