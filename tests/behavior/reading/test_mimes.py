"""Mimes are found by verb and object, for a person who does it, and not for other senses of the verb."""

from pathlib import Path

import pytest

from understudy.behavior.reading.mimes import MIME_LOG_ODDS, Mime, MimeTable, mimes_in
from understudy.errors import AuthoringError
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
    analysis = spoken(understudy, "You stir the soup, and then you knock on the door.")
    behaviors = perform_analysis(understudy, analysis, Options()).behaviors
    stirring = [each for each in behaviors if each.kept and each.lexeme == "MIME_STIR"]
    assert len(stirring) == 1
    assert stirring[0].kind is Channel.GESTURE
    assert "mime of 'stir'" in {part.name for part in stirring[0].decided_by}


BEHAVIORS = {"mime_ring", "mime_stir"}


def load(folder: Path, text: str) -> MimeTable:
    path = folder / "mimes.yaml"
    path.write_text(text, encoding="utf-8")
    return MimeTable.load(path, BEHAVIORS)


def test_actions_are_kept_by_verb_in_the_order_of_the_file(tmp_path: Path) -> None:
    table = load(
        tmp_path,
        "people: [man]\nmimes:\n  mime_ring:\n    - {verbs: [ring], objects: [bell]}\n  mime_stir:\n"
        "    - {verbs: [stir, ring], without: [up], doer: told}\n",
    )
    assert [each.name for each in table.by_verb["ring"]] == ["mime_ring", "mime_stir"]
    (stir,) = table.by_verb["stir"]
    assert (stir.objects, stir.without, stir.told) == (frozenset(), frozenset({"up"}), True)


def test_an_unknown_behaviour_is_a_mistake_with_its_place_and_a_guess(tmp_path: Path) -> None:
    with pytest.raises(AuthoringError, match=r"no behaviour is called 'mime_rnig'.*mime_ring") as caught:
        load(tmp_path, "people: [man]\nmimes:\n  mime_rnig:\n    - {verbs: [ring]}\n")
    assert [mistake.line for mistake in caught.value.mistakes] == [4]


@pytest.mark.parametrize("line", ["{verbs: []}", "{verbs: [Ring]}", "{objects: [bell]}", "{verbs: [ring], doer: they}"])
def test_wrong_lines_are_mistakes(tmp_path: Path, line: str) -> None:
    with pytest.raises(AuthoringError):
        load(tmp_path, f"people: [man]\nmimes:\n  mime_ring:\n    - {line}\n")
