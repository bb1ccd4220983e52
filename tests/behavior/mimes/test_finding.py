"""Mimes are found by verb and object, for a person who does it, and not for other senses of the verb."""

import pytest

from understudy.behavior.mimes.finding import MIME_LOG_ODDS, Mime, mimes_in
from understudy.model import Channel
from understudy.models import Understudy
from understudy.options import Options
from understudy.performance import perform_analysis
from understudy.rules.stage import find_functions

from ..candidates.test_demands import spoken


def found(understudy: Understudy, text: str) -> list[tuple[str, int, int]]:
    tokens = find_functions(understudy.language, text).utterance.parse.tokens
    return [(each.name, each.first, each.last) for each in mimes_in(understudy.behavior.planner.mimes, tokens)]


@pytest.mark.parametrize(
    ("text", "mime", "words"),
    [
        ("And then she climbed the ladder.", "mime_climb", (3, 5)),
        ("He knocks on the window.", "mime_knock", (1, 4)),
        ("Stir it slowly.", "mime_stir", (0, 1)),
        ("My mother combed my hair every morning.", "mime_comb", (2, 4)),
        ("I had to wring the towels.", "mime_wring", (3, 5)),
        ("Anna rang the bell.", "mime_ring", (1, 3)),
        ("He folded the letter.", "mime_fold", (1, 3)),
    ],
)
def test_an_action_is_found_from_its_verb_to_its_object(
    understudy: Understudy, text: str, mime: str, words: tuple[int, int]
) -> None:
    assert found(understudy, text) == [(mime, *words)]


@pytest.mark.parametrize(
    "text",
    [
        "Knock it off, will you?",  # another sense
        "It rings true to me.",  # no object of the action
        "The wind swept the valley.",  # no person
        "They live by the old climb.",  # no verb
        "You came here last year.",  # nobody is told to
    ],
)
def test_other_senses_are_no_mimes(understudy: Understudy, text: str) -> None:
    assert found(understudy, text) == []


def test_a_doer_is_handed_on_to_joined_verbs(understudy: Understudy) -> None:
    assert found(understudy, "The lid closed and opened the box.") == []
    assert [name for name, *_ in found(understudy, "She closed the box and opened the window.")] == [
        "mime_close",
        "mime_open",
    ]


def test_a_mime_names_the_verb_as_a_part_of_its_worth(understudy: Understudy) -> None:
    assert Mime("mime_stir", 0, 1, "stir").part.weight == MIME_LOG_ODDS
    analysis = spoken(understudy, "You stir it slowly, and then you knock on the door.")
    behaviors = perform_analysis(understudy, analysis, Options()).behaviors
    stirring = [each for each in behaviors if each.kept and each.lexeme == "MIME_STIR"]
    assert len(stirring) == 1
    assert stirring[0].kind is Channel.GESTURE
    assert "mime of 'stir'" in {part.name for part in stirring[0].decided_by}
