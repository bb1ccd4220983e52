"""Which gestures can be shown on which words, with the shipped families."""

from dataclasses import replace

import pytest

from understudy.behavior.reading.conditions import lemmas_about, possible_families, possible_lexemes
from understudy.behavior.reading.player import Player
from understudy.behavior.reading.strokes import NEAR
from understudy.model import DEFAULT_CHARACTER, Agitation, Channel, Moment, Utterance
from understudy.models import Understudy
from understudy.rules.stage import find_functions

LINE = "My uncle said that we could all drink from it, behind his house."
DRINK = LINE.split().index("drink")


@pytest.fixture(scope="module")
def player(understudy: Understudy) -> Player:
    behavior = understudy.behavior
    return Player(behavior.families, behavior.characters.named(DEFAULT_CHARACTER).entries)


@pytest.fixture(scope="module")
def utterance(understudy: Understudy) -> Utterance:
    return find_functions(understudy.language, LINE).utterance


def words_of(lexeme: str, player: Player, utterance: Utterance) -> list[int]:
    """The words on which a lexeme can be shown."""
    possible = possible_lexemes({"BEAT": 0, lexeme: 1}, player, utterance)
    assert possible[:, 0].all()
    return [word for word, shown in enumerate(possible[:, 1]) if shown]


def test_a_mime_is_possible_near_its_word_alone(player: Player, utterance: Utterance) -> None:
    assert words_of("MIME_DRINK", player, utterance) == list(range(DRINK - NEAR, DRINK + NEAR + 1))
    assert words_of("MIME_SEW", player, utterance) == []


def test_a_stroke_shows_the_words_of_its_window_alone(player: Player, utterance: Utterance) -> None:
    """Of two strokes about a word, the one in whose window it lies can show it; words without strokes are as before."""
    before, after, without = DRINK - 2, DRINK + 1, DRINK + 2
    windows = {before: (NEAR, 0), after: (1, NEAR)}
    possible = possible_lexemes({"MIME_DRINK": 0}, player, utterance, windows)[:, 0]
    assert [bool(possible[word]) for word in (before, after, without)] == [False, True, True]


def test_what_is_also_listed_for_any_words_is_possible_everywhere(player: Player, utterance: Utterance) -> None:
    """A finger ahead goes before an open hand where something is "straight ahead", and is right elsewhere too."""
    assert words_of("POINT_FRONT", player, utterance) == list(range(len(utterance.words)))


def test_what_the_families_do_not_list_is_not(player: Player, utterance: Utterance) -> None:
    assert words_of("SMALL", player, utterance) == []


def test_some_suit_a_level_of_agitation_alone(player: Player, utterance: Utterance) -> None:
    agitated = replace(utterance, agitation=Agitation(0.0, 0.0, 1.0))
    calm = replace(utterance, agitation=Agitation(1.0, 0.0, 0.0))
    assert words_of("YOU", player, calm) == []
    assert words_of("YOU", player, agitated) == list(range(len(utterance.words)))


def test_a_family_that_needs_words_is_possible_near_them(utterance: Utterance) -> None:
    possible = possible_families({"emblem_other": frozenset({"drink"})}, ("present", "emblem_other"), utterance)
    assert possible[:, 0].all()
    assert possible[:, 1].nonzero()[0].tolist() == list(range(DRINK - NEAR, DRINK + NEAR + 1))


def test_the_lemmas_about_a_moment_are_those_of_its_words_and_near_its_stroke(utterance: Utterance) -> None:
    moment = Moment("m", Channel.GESTURE, DRINK + 1, DRINK + 2, DRINK + 1, ("emblem_other",), 1.0)
    assert {"drink", "from", "all"} <= lemmas_about(utterance, moment)
    assert "uncle" not in lemmas_about(utterance, moment)
