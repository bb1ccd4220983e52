"""The paper's Figure 8 the whole way, on audio of our own in which "guess" and "those" are said louder.

As in the paper, the stressed ratio emphasises, and functions choose by priority alone. Prominence heeds length and
pitch as well, which flite varies little.
"""

from dataclasses import replace
from pathlib import Path

import pytest

from understudy.model import Performance
from understudy.performance import Line, Options, Understudy, perform
from understudy.settings import Settings

AUDIO = Path(__file__).parents[1] / "audio" / "figure8.flac"


@pytest.fixture(scope="module")
def performance(understudy: Understudy) -> Performance:
    settings = Settings(emphasis="ratio", choice="priority")
    paper = replace(
        understudy,
        acoustic=replace(understudy.acoustic, settings=settings),
        behavior=replace(understudy.behavior, settings=settings),
    )
    return perform(paper, Line(AUDIO.read_bytes(), AUDIO.with_suffix(".txt").read_text()), Options())


def _spans(performance: Performance, class_name: str, subtype: str = "plain") -> set[tuple[int, int]]:
    return {
        (function.first, function.last)
        for function in performance.functions
        if function.kept and (function.class_name, function.subtype) == (class_name, subtype)
    }


def _lexemes(performance: Performance, class_name: str, word: int) -> set[str]:
    """What the body was asked to do for a function that begins at `word`, also where a neighbour won."""
    asked = {
        function.id
        for function in performance.functions
        if function.class_name == class_name and function.first == word
    }
    return {behavior.lexeme for behavior in performance.behaviors if behavior.function in asked}


def test_the_stressed_words_are_emphasised(performance: Performance) -> None:
    words = performance.utterance.words
    stressed = {word.index for word in words if word.stressed_ratio is not None and word.stressed_ratio > 0.1}
    assert stressed >= {1, 10}
    assert _spans(performance, "emphasis") == {(index, index) for index in stressed}


def test_prominence_hears_emphasis_in_a_flat_voice_too_and_less_of_it(
    understudy: Understudy, performance: Performance
) -> None:
    ours = perform(understudy, Line(AUDIO.read_bytes(), AUDIO.with_suffix(".txt").read_text()), Options())
    found = {first for first, _ in _spans(ours, "emphasis")}
    assert 1 in found
    assert len(found) < len(_spans(performance, "emphasis"))


def test_the_functions_are_those_of_the_figure(performance: Performance) -> None:
    assert _spans(performance, "deixis", "self") == {(0, 0), (3, 3), (5, 5)}
    assert _spans(performance, "negation") == {(2, 2)}
    assert _spans(performance, "deixis", "distal") == {(10, 10), (10, 11)}
    assert _spans(performance, "quantification", "all") == {(8, 8)}
    assert _spans(performance, "initial_noun_phrase") == {(0, 0)}
    assert _spans(performance, "initial_verb_phrase") == {(1, 1)}


def test_self_is_shown_by_the_gesture_me(performance: Performance) -> None:
    for word in (0, 3, 5):
        assert "ME" in _lexemes(performance, "deixis", word)


def test_not_is_shown_by_a_shake_with_the_negation_gesture(performance: Performance) -> None:
    shown = {behavior.lexeme for behavior in performance.behaviors if behavior.kept and behavior.first == 2}
    assert {"SHAKE", "NEGATION"} <= shown
