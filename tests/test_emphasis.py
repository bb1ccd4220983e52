"""Which words the shipped rules emphasise, by either measure of how much they stand out."""

from dataclasses import replace

import pytest

from app.model import Utterance
from app.rules.derivation import Emphasis, derive_functions
from tests.shipped_rules import shipped_rules
from tests.utterances import utterance, words_of


def _emphasised(emphasis: Emphasis, *measured: tuple[float, float | None]) -> list[int]:
    """The emphasised among words of these stressed ratios and prominences."""
    words = words_of("so it")
    heard = [
        replace(word, stressed_ratio=one, prominence=two) for word, (one, two) in zip(words, measured, strict=True)
    ]
    spoken = Utterance(tuple(heard), utterance("", "").parse)
    functions = derive_functions(shipped_rules(), spoken, emphasis=emphasis)
    return [found.first for found in functions if found.class_name == "emphasis"]


@pytest.mark.parametrize(
    ("emphasis", "expected"),
    [
        (Emphasis(), [1]),
        (Emphasis(above_prominence=0.35), [0, 1]),
        (Emphasis(measure="ratio"), [0]),
        (Emphasis(measure="ratio", above_ratio=0.0), [0, 1]),
    ],
)
def test_words_are_emphasised_above_the_threshold_of_the_measure_that_is_set(
    emphasis: Emphasis, expected: list[int]
) -> None:
    assert _emphasised(emphasis, (0.2, 0.4), (0.1, 0.41)) == expected


def test_a_word_without_prominence_is_judged_by_its_ratio() -> None:
    assert _emphasised(Emphasis(), (0.11, None), (0.1, None)) == [0]
