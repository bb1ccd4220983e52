"""Evaluation that is not meant literally, demonstratives that point at nothing, "must" without obligation."""

import pytest

from tests.support.shipped_rules import facts

DENIED = [
    ("The dentist was not terrible.", {"terrible."}),
    ("That isn't a bad car.", {"bad"}),
    ("There was no danger.", {"danger."}),
    ("The dentist was terrible.", set()),
    ("No, that is a bad car.", set()),
]
IRONIC = [
    ("Oh, wonderful. Now we lost the keys.", {"wonderful."}),
    ("Yeah, right.", {"Yeah, right."}),
    ("Thanks for nothing.", {"Thanks for nothing."}),
    ("Thanks a lot. Now you broke it.", {"Thanks a lot."}),
    ("Oh, wonderful. I am so happy for you.", set()),
    ("Great, see you there.", set()),
    ("Yeah, that is right.", set()),
    ("Thanks a lot. You helped me.", set()),
]
OF_TALK = [
    ("That's OK.", {("That's",)}),
    ("This is true.", {("This",)}),
    ("I knew that.", {("that.",)}),
    ("There you go.", {("There",)}),
    ("Look at that.", set()),
    ("That house is empty.", set()),
    ("That's my brother.", set()),
]
DIRECTED = [("The lamp is up there.", {("there.",)}), ("Put it there on the left.", set()), ("It hangs there.", set())]
PERFORMATIVE = [
    ("I must apologise.", {("must",)}),
    ("I have to admit it works.", {("have to",)}),
    ("You have to apologise.", set()),
    ("I must leave.", set()),
]


@pytest.mark.parametrize(("text", "expected"), DENIED)
def test_evaluation_that_is_denied(text: str, expected: set[str]) -> None:
    assert {words for (words,) in facts(text, "denied_evaluation")} == expected


@pytest.mark.parametrize(("text", "expected"), IRONIC)
def test_praise_and_thanks_before_bad_news_are_not_meant(text: str, expected: set[str]) -> None:
    assert {words for (words,) in facts(text, "ironic")} == expected


@pytest.mark.parametrize(("text", "expected"), OF_TALK)
def test_a_demonstrative_that_takes_up_what_was_said_points_nowhere(text: str, expected: set[tuple[str, ...]]) -> None:
    assert facts(text, "refers_to_talk") == expected


@pytest.mark.parametrize(("text", "expected"), DIRECTED)
def test_a_place_beside_a_direction_is_directed(text: str, expected: set[tuple[str, ...]]) -> None:
    assert facts(text, "directed") == expected


@pytest.mark.parametrize(("text", "expected"), PERFORMATIVE)
def test_a_duty_done_by_saying_it_is_none(text: str, expected: set[tuple[str, ...]]) -> None:
    assert facts(text, "performative") == expected
