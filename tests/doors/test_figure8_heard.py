"""The paper's Figure 8 through all stages, on audio of our own in which "guess" and "those" are spoken louder.

As in the paper, emphasis is the stressed ratio, and functions choose by priority alone. Prominence also depends on
duration and pitch, which flite varies little.
"""

from dataclasses import replace
from pathlib import Path

import pytest

from understudy.behavior.timing.anchoring import stressed_vowel_s
from understudy.model import Channel, DirectedMoment, Direction, Level, Line, Performance
from understudy.models import Understudy
from understudy.options import Options
from understudy.performance import perform
from understudy.realization import realize, schedule_of
from understudy.settings import Settings

AUDIO = Path(__file__).parents[1] / "audio" / "figure8.flac"


LINE = Line(AUDIO.read_bytes(), AUDIO.with_suffix(".txt").read_text())

NOTES = Direction(
    (
        *(DirectedMoment(word, word, word, 3, gesture=("self",)) for word in (0, 3, 5)),
        DirectedMoment(2, 2, 2, 3, gesture=("negation",), head=("shake",)),
        DirectedMoment(8, 8, 8, 3, gesture=("all_sweep",)),
        DirectedMoment(10, 11, 10, 3, gesture=("point_there",)),
    )
)
"""What the figure shows, as a director would ask for it."""

NEGATIONS = frozenset({"NEGATION", "PUSH_AWAY"})
ALL = frozenset({"SURROUND", "INCLUSIVITY", "SWEEP_ALL"})


@pytest.fixture(scope="module")
def paper(understudy: Understudy) -> Understudy:
    return understudy.with_settings(Settings(emphasis="ratio", choice="priority"))


@pytest.fixture(scope="module")
def performance(paper: Understudy) -> Performance:
    return perform(paper, LINE, Options())


def _struck(performance: Performance) -> list[tuple[int, str]]:
    """The gestures that are made, each with the word about whose stressed vowel its stroke ends, but a syllable early
    at most."""
    vowels_s = {word.index: stressed_vowel_s(word) for word in performance.utterance.words}
    made = [each for each in performance.behaviors if each.kept and each.kind is Channel.GESTURE]
    ends_s = [(each.sync.stroke_end or 0.0, each.lexeme) for each in made]
    return [
        (min(vowels_s, key=lambda index: (not -0.02 <= vowels_s[index] - end_s <= 0.11, index)), lexeme)
        for end_s, lexeme in sorted(ends_s)
    ]


def _are_played(understudy: Understudy, performance: Performance) -> bool:
    """Whether the realizer makes every gesture of a performance, in its time."""
    motion = realize(understudy.realizer, schedule_of(performance))
    return not [each for each in motion.decisions if each.action in ("dropped", "late")]


def _spans(performance: Performance, class_name: str, subtype: str = "plain") -> set[tuple[int, int]]:
    """The words of the functions that were derived, whether they were kept or not."""
    return {
        (function.first, function.last)
        for function in performance.functions
        if (function.class_name, function.subtype) == (class_name, subtype)
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
    ours = perform(understudy, LINE, Options())
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


def test_of_functions_on_the_same_words_the_most_important_is_kept(performance: Performance) -> None:
    """§3.3: the emphasis of "those" gives way to the pointing, and that to the joined one, which is more specific."""
    kept = [function for function in performance.functions if function.kept]
    words = [word for function in kept for word in range(function.first, function.last + 1)]
    assert len(words) == len(set(words))
    by_id = {function.id: function for function in performance.functions}
    lost = {
        function.class_name: by_id[function.lost_to or ""]
        for function in performance.functions
        if not function.kept and function.last == 10
    }
    assert {name: (each.class_name, each.first, each.last) for name, each in lost.items()} == {
        "emphasis": ("deixis", 10, 11),
        "deixis": ("deixis", 10, 11),
    }


def test_self_is_shown_by_the_gesture_me(performance: Performance) -> None:
    for word in (0, 3, 5):
        assert "ME" in _lexemes(performance, "deixis", word)


def test_not_is_shown_by_a_shake_with_the_negation_gesture(performance: Performance) -> None:
    shown = {behavior.lexeme for behavior in performance.behaviors if behavior.kept and behavior.first == 2}
    assert {"SHAKE", "NEGATION"} <= shown


@pytest.mark.parametrize("lead_in_s", [0.0, 0.6])
@pytest.mark.parametrize("agitation", Level)
def test_a_director_has_all_six_strokes_and_the_shake(
    understudy: Understudy, agitation: Level, lead_in_s: float
) -> None:
    options = Options(agitation=agitation, lead_in_s=lead_in_s)
    played = perform(understudy, replace(LINE, direction=NOTES), options)
    assert not [notice for notice in played.notices if notice.code == "direction_unplayed"]
    by_note = {each.moment: each.lexeme for each in played.behaviors if each.kept and each.moment}
    assert [by_note[f"note{note}.gesture"] for note in range(3)] == ["ME"] * 3
    assert (by_note["note3.gesture"], by_note["note3.head"]) == ("NEGATION", "SHAKE")
    assert by_note["note4.gesture"] in ALL
    assert by_note["note5.gesture"] in {"THERE", "POINT_FRONT"}
    assert _are_played(understudy, played)


def test_by_priority_an_agitated_speaker_makes_them_all(paper: Understudy) -> None:
    """As in the figure, whose speaker is highly agitated; the mapping draws, and this draw shows all by the hands."""
    played = perform(paper, LINE, Options(agitation=Level.HIGH, lead_in_s=0.6, seed=1))
    struck = _struck(played)
    assert [word for word, lexeme in struck if lexeme == "ME"] == [0, 3, 5]
    assert [word for word, lexeme in struck if lexeme in NEGATIONS] == [2]
    assert [word for word, lexeme in struck if lexeme in ALL] == [8]
    assert [word for word, lexeme in struck if lexeme.startswith("POINT")] == [10]
    assert _are_played(paper, played)


@pytest.mark.parametrize("seed", range(6))
def test_by_priority_the_hands_show_self_three_times_and_the_denial_whatever_is_drawn(
    paper: Understudy, seed: int
) -> None:
    played = perform(paper, LINE, Options(agitation=Level.HIGH, lead_in_s=0.6, seed=seed))
    struck = _struck(played)
    assert [word for word, lexeme in struck if lexeme == "ME"] == [0, 3, 5]
    assert [word for word, lexeme in struck if lexeme in NEGATIONS] == [2]


def test_agitation_drives_how_much_functions_ask_for(paper: Understudy) -> None:
    counts = [len(_struck(perform(paper, LINE, Options(agitation=level, lead_in_s=0.6, seed=1)))) for level in Level]
    assert counts[0] < counts[-1]
