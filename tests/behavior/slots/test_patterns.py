"""Patterns of words match tokens, and say what is wrong with them."""

import pytest

from tests.support.words.utterances import utterance
from understudy.behavior.slots.patterns import find, read_pattern
from understudy.model import Token

NUMBERS = {"two": 2.0}
TOKENS = "0:Two/two/NUM 1:old/old/ADJ 2:Doors/door/NOUN 2:,/,/PUNCT 3:left/leave/VERB"


def tokens() -> tuple[Token, ...]:
    return utterance("Two old Doors, left", TOKENS).parse.tokens


@pytest.mark.parametrize(
    ("pattern", "found"),
    [
        ("door", [(2, 2)]),
        ("doors", [(2, 2)]),
        ("old|new door", [(1, 2)]),
        ("<things>", [(2, 2)]),
        ("#", [(0, 0)]),
        ("# ADJ? NOUN", [(0, 2)]),
        ("# NOUN", []),
        ("left/ADJ", []),
        ("left/VERB+ADJ", [(4, 4)]),
        ("two ... door", [(0, 2)]),
        ("two ... left", []),
        ("door , left", [(2, 4)]),
    ],
)
def test_what_a_pattern_matches(pattern: str, found: list[tuple[int, int]]) -> None:
    read = read_pattern(pattern, {"things": ["door"]})
    assert [(each.first, each.last) for each in find(read, tokens(), NUMBERS)] == found


def test_the_number_and_the_name_of_a_match() -> None:
    (match,) = find(read_pattern("# ADJ @NOUN", {}), tokens(), NUMBERS)
    assert (match.number, match.named) == (0, 2)


@pytest.mark.parametrize(
    ("pattern", "told"),
    [("<thongs>", "no set is called 'thongs'"), ("a/noun", "is not an element"), ("the? ...", "needs a word")],
)
def test_mistakes_are_told(pattern: str, told: str) -> None:
    with pytest.raises(ValueError, match=told):
        read_pattern(pattern, {})
