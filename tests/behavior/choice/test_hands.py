"""Which hand makes what is asked for, with the library's gestures."""

from dataclasses import replace

import pytest

from tests.support.characters import CHARACTERS
from tests.support.words.by_hand import movement, spoken
from understudy.behavior.characters.gesture_forms import with_forms
from understudy.behavior.choice.hands import fitted_as_asked
from understudy.behavior.timing.anchoring import asked
from understudy.behavior.timing.conflicts import FittedBehavior
from understudy.behavior.timing.time_index import TimeIndex
from understudy.model import Behavior, Hand, Level
from understudy.models import load_gesture_table

DEFAULT = with_forms(CHARACTERS.named("default"), load_gesture_table(CHARACTERS.gesture_lexemes), Level.MEDIUM)


def made(
    *names: tuple[str, int, Hand], word_s: float = 0.3, by_either_hand: bool = True
) -> tuple[list[Behavior], Behavior | None]:
    """What is kept of gestures on words of .3 s, and what was refused last."""
    words = spoken(" ".join(["word"] * 20), word_s=word_s)
    kept = TimeIndex()
    refused: Behavior | None = None
    for name, word, hand in names:
        entry = DEFAULT.entries[name]
        candidate = asked(movement(name, word), entry, words, f"{name}.{word}", may_be_brief=True)
        behavior = replace(candidate.behavior, hand=hand)
        outcome = fitted_as_asked(
            replace(candidate, behavior=behavior), kept, hand=entry.hand, by_either_hand=by_either_hand
        )
        if isinstance(outcome, FittedBehavior):
            kept = outcome.kept
        else:
            refused = outcome
    return [each.behavior for each in kept], refused


RIGHT, BOTH = Hand.RIGHT, Hand.BOTH


def test_the_other_hand_makes_what_the_usual_one_has_no_time_for() -> None:
    asked_for = (("gesture_me", 5, RIGHT), ("gesture_negation", 6, RIGHT))
    kept, _ = made(*asked_for)
    assert [each.hand for each in kept] == [Hand.RIGHT, Hand.LEFT]
    kept, refused = made(*asked_for, by_either_hand=False)
    assert len(kept) == 1
    assert "too close to ME" in (refused.reason or "" if refused else "")


def test_a_gesture_of_both_hands_leaves_one_to_the_next() -> None:
    kept, _ = made(("gesture_surround", 5, BOTH), ("gesture_point_right", 6, RIGHT))
    assert {each.lexeme: each.hand for each in kept} == {"SURROUND": Hand.LEFT, "POINT_RIGHT": Hand.RIGHT}


def test_a_gesture_of_both_hands_is_made_with_the_one_that_is_free() -> None:
    kept, _ = made(("gesture_negation", 5, RIGHT), ("gesture_surround", 6, BOTH), word_s=0.4)
    assert {each.lexeme: each.hand for each in kept} == {"NEGATION": Hand.RIGHT, "SURROUND": Hand.LEFT}


def test_two_hands_do_not_strike_at_once() -> None:
    kept, refused = made(("gesture_point_left", 5, Hand.LEFT), ("gesture_point_right", 5, RIGHT))
    assert [each.lexeme for each in kept] == ["POINT_LEFT"]
    assert refused is not None
    assert refused.reason == "the other hand is in use for POINT_LEFT"


@pytest.mark.parametrize("word", [5, 6])
def test_the_same_gesture_at_the_same_time_is_made_once(word: int) -> None:
    kept, refused = made(("gesture_me", 5, RIGHT), ("gesture_me", word, RIGHT))
    assert len(kept) == (1 if word == 5 else 2)
    assert word != 5 or (refused is not None and refused.reason == "ME shows it already")
