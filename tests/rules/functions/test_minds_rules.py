"""Rules about whose thoughts and feelings are reported."""

import pytest

from tests.support.shipped_rules import facts

THINKERS = [
    ("I believe her.", {("self", "believe")}),
    ("My sister would hate it.", {("other", "hate")}),
    ("If you need rest, and worry too much, sleep.", {("addressee", "worry")}),
    ("What do you think happened?", {("addressee", "think")}),
    ("They told us they wanted more.", {("other", "wanted")}),
    ("He knew that I remember everything.", {("other", "knew"), ("self", "remember")}),
    ("I want you to understand this.", {("self", "want"), ("addressee", "understand")}),
    ("Let me remember his name.", {("self", "remember")}),
    ("She looked worried.", {("other", "worried.")}),
    ("We have no idea.", {("inclusive", "no idea.")}),
    ("You finally made up your mind.", {("addressee", "made up your mind.")}),
    ("You never know with cats.", {("generic", "never know")}),
    ("Glad you could come.", {("self", "Glad")}),
    ("Remember the milk.", {("addressee", "Remember")}),
    ("Who knows?", {("self", "Who knows?")}),
    ('She said, "I love this town."', {("quoted", "love")}),
    ("They need time to think.", {("other", "think.")}),
]


@pytest.mark.parametrize(("text", "expected"), THINKERS)
def test_a_mental_state_is_that_of_whoever_has_it(text: str, expected: set[tuple[str, ...]]) -> None:
    assert facts(text, "thinker") == expected
