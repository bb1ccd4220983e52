"""Which movements the shipped mapping rules offer for a line, depending on the facts about it."""

from pathlib import Path

import pytest

from tests.support.shipped_rules import shipped_parser, shipped_rules
from tests.support.words.utterances import words_of
from understudy.behavior.characters.overlays import Characters
from understudy.model import Utterance
from understudy.rules.derivation import understand
from understudy.rules.mapping import MappingRules, offer_movements

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture(scope="module")
def rules() -> MappingRules:
    return MappingRules.load(ROOT / "app" / "rules", Characters.load(ROOT / "lexicon").callable_names)


def offered(rules: MappingRules, text: str) -> set[str]:
    """Every behaviour that could show something in the line."""
    words = words_of(text)
    utterance = Utterance(words, shipped_parser().parse(words))
    known = understand(shipped_rules(), utterance)
    return {
        movement.name
        for candidates in offer_movements(rules, utterance, known.functions, seed=0, facts=known.facts)
        for alternative in candidates.alternatives
        for movement in alternative.movements
    }


NEVER_AND_YET = [
    ("My aunt would love it.", {"gesture_me", "gesture_me_both"}, "I would love it."),
    ("My bike vanished.", {"gesture_me"}, "It is my bike, not your bike."),
    ("What do they think about it?", {"gesture_think"}, "I think about it."),
    ("You never know with cats.", {"gesture_you"}, "I know you."),
    ('He yelled, "I quit!"', {"gesture_me"}, "I quit!"),
    ("That's fine.", {"gesture_point_left", "gesture_point_right"}, "That house burnt down."),
    ("The lamp is up there.", {"gesture_point_left", "gesture_point_right"}, "The lamp stood there."),
    ("Did you see anything?", {"gesture_pinch"}, "We saw few people."),
    ("He owns nine boats.", {"gesture_count"}, "There are two reasons."),
    ("The dentist was not terrible.", {"mouth_down", "nose_wrinkle"}, "The dentist was terrible."),
    ("Oh, wonderful. Now we lost the keys.", {"smile", "small_smile"}, "Oh, wonderful."),
    ("Thanks a lot. Now you broke it.", {"gesture_thanks"}, "Thanks a lot."),
    ("I must apologise.", {"gesture_obligation"}, "I must leave."),
]


@pytest.mark.parametrize(("text", "wrong", "right"), NEVER_AND_YET)
def test_a_movement_is_offered_only_where_the_words_mean_it(
    rules: MappingRules, text: str, wrong: set[str], right: str
) -> None:
    assert offered(rules, text) & wrong == set()
    assert offered(rules, right) & wrong
