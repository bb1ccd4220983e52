"""Rules about who does what in each clause, and its mood."""

import pytest

from tests.support.shipped_rules import at, facts

AGENTS = [
    ("I opened the door.", {("self", "opened")}),
    ("My neighbour opened the door.", {("other", "opened")}),
    ("She came and left.", {("other", "came"), ("other", "left.")}),
    ("We want to leave.", {("inclusive", "want"), ("inclusive", "leave.")}),
    ("I want you to leave.", {("self", "want"), ("addressee", "leave.")}),
    ("Close the window.", {("addressee", "Close")}),
    ("If it rains, close the window.", {("other", "rains,"), ("addressee", "close")}),
    ("Don't you touch that vase!", {("addressee", "touch")}),
    ("Hope it works.", {("self", "Hope"), ("other", "works.")}),
    ("Who broke the vase?", {("asked", "broke")}),
]
GENERIC = [
    ("You never know with cats.", {("You",)}),
    ("You can hear the sea from the kitchen.", {("You",)}),
    ("When you drink too much, you sleep badly.", {("you",)}),
    ("You'd think they would learn.", {("You'd",)}),
    ("Your average tourist stays two days.", {("Your",)}),
    ("You never called me.", set()),
    ("Can you hear the sea?", set()),
    ("You always were my favourite.", set()),
    ("When you see her, tell her to wait.", set()),
]
MOODS = [
    ("He left early.", {"declarative"}),
    ("Leave the keys here.", {"imperative"}),
    ("Please don't shout.", {"imperative"}),
    ("Where did he go?", {"wh"}),
    ("Did he leave the keys?", {"polar"}),
    ("What a lovely garden!", {"exclamative"}),
    ("Sit down and I will explain it.", {"imperative", "declarative"}),
    ("Thank you for the flowers.", {"declarative"}),
    ("Don't you ever do it again!", {"imperative"}),
]


@pytest.mark.parametrize(("text", "expected"), AGENTS)
def test_each_clause_has_the_person_of_its_subject_also_where_it_is_understood(
    text: str, expected: set[tuple[str, ...]]
) -> None:
    assert at(text, "agent") >= expected
    verbs = {word for _, word in expected}
    assert {found for found in at(text, "agent") if found[1] in verbs} == expected


@pytest.mark.parametrize(("text", "expected"), GENERIC)
def test_you_that_means_anybody_is_told_from_the_listener(text: str, expected: set[tuple[str, ...]]) -> None:
    assert at(text, "generic_you") == expected


@pytest.mark.parametrize(("text", "expected"), MOODS)
def test_each_main_clause_has_a_mood(text: str, expected: set[str]) -> None:
    assert {found[0] for found in facts(text, "mood")} == expected
