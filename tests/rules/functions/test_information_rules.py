"""Rules about given and new information, contrast, focus and denial."""

import pytest

from tests.support.shipped_rules import at, facts, found

FOCUS = [
    ("Only Peter stayed.", {("only", "Peter")}),
    ("Even the dog was bored.", {("even", "the dog")}),
    ("It was the gardener who found it.", {("cleft", "the gardener")}),
    ("What she needs is a long holiday.", {("cleft", "a long holiday.")}),
    ("How many tickets did you buy?", {("question", "How many tickets")}),
    ("Did you buy the tickets?", {("question", "tickets?")}),
    ("I ordered not tea but coffee.", {("correction", "coffee."), ("contrast", "tea"), ("contrast", "coffee.")}),
    ("The soup was not only cold but also salty.", {("also", "salty."), ("contrast", "cold"), ("contrast", "salty.")}),
    ("He is an only child.", set()),
    ("She left just now.", set()),
]
DENIED = [
    ("The film was not funny.", {"funny."}),
    ("She never answered my letter.", {"answered", "letter."}),
    ("There is no bread.", {"bread."}),
    ("I don't think the plan is clever.", {"clever."}),
    ("No, the plan is good.", set()),
    ("It is not only cheap but also good.", set()),
    ("Why don't we go home?", set()),
]


@pytest.mark.parametrize(("text", "expected"), FOCUS)
def test_focus(text: str, expected: set[tuple[str, ...]]) -> None:
    found_focus = facts(text, "focus")
    assert found_focus >= expected
    assert {kind for kind, _ in found_focus if kind != "only"} == {kind for kind, _ in expected if kind != "only"}


@pytest.mark.parametrize(("text", "expected"), DENIED)
def test_what_a_negation_denies(text: str, expected: set[str]) -> None:
    words = text.split()
    denied = {words[int(position)] for position, _negation in at(text, "negated")}
    assert denied >= expected
    assert bool(denied) == bool(expected)


def test_a_noun_is_new_once_and_known_afterwards() -> None:
    text = "I bought a lamp yesterday, but the lamp is broken."
    assert heads(text, "new_phrase") == {"lamp"}
    assert heads(text, "given_phrase") == {"I", "lamp"}
    assert heads("A lamp is on the table.", "definite_phrase") == {"table."}


def heads(text: str, predicate: str) -> set[str]:
    return {found[-1] for found in at(text, predicate)}


def test_not_only_is_no_contrast_but_an_addition() -> None:
    assert found("The soup was not only cold but also salty.", "contrast") == []
    assert found("The soup was not cold but salty.", "contrast") == [("plain", "but")]
