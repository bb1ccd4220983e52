"""The behaviours offered for a moment, with a small hand-made table of families."""

from dataclasses import dataclass, replace
from types import MappingProxyType

import numpy as np
import pytest

from understudy.behavior.candidates.planned import ASKED_BY_LEMMA, LEAST_BEHIND, USUAL_POINTING, candidates_of
from understudy.behavior.reading.choice_model import ChoiceModel
from understudy.behavior.reading.families import Families, FamilyBehavior
from understudy.behavior.reading.planning import Plan
from understudy.behavior.reading.player import Ban, Player
from understudy.behavior.reading.worths import LineWorths
from understudy.model import (
    Alternative,
    BehaviorCandidates,
    Channel,
    Function,
    Moment,
    Movement,
    Parse,
    Term,
    Token,
    Utterance,
    Word,
)


@dataclass(frozen=True)
class Entry:
    channel: Channel
    lexeme: str


BEHAVIORS = {
    "open_hand": Entry(Channel.GESTURE, "OPEN_HAND"),
    "wipe": Entry(Channel.GESTURE, "NEGATION"),
    "away": Entry(Channel.GESTURE, "DISMISS"),
    "drink": Entry(Channel.GESTURE, "MIME_DRINK"),
    "nod": Entry(Channel.HEAD, "NOD"),
    "glance": Entry(Channel.GAZE, "GLANCE"),
}
FAMILIES = Families(
    gesture=MappingProxyType(
        {
            "present": (FamilyBehavior("open_hand"),),
            "negation": (FamilyBehavior("wipe"), FamilyBehavior("away")),
            "emblem_other": (FamilyBehavior("drink", frozenset(["drink"])),),
        }
    ),
    head=MappingProxyType({"nod": (FamilyBehavior("nod"),)}),
    face=MappingProxyType({}),
    gaze=MappingProxyType({}),
    shows=MappingProxyType(
        {
            "OPEN_HAND": ("present",),
            "NEGATION": ("negation",),
            "DISMISS": ("dismiss", "negation"),
            "MIME_DRINK": ("emblem_other",),
        }
    ),
)
PLAYER = Player(FAMILIES, BEHAVIORS)


def utterance(text: str) -> Utterance:
    words = tuple(Word(index, word) for index, word in enumerate(text.split()))
    tokens = tuple(
        Token(word.index, word.index, word.text, word.text.lower(), "X", "X", "dep", word.index) for word in words
    )
    return Utterance(words, Parse(tokens, (), ()))


def moment(*families: str, shares: tuple[float, ...], stroke: int = 1) -> Moment:
    return Moment("moment.gesture.1", Channel.GESTURE, 0, 2, stroke, families, 0.5, shares)


def offer(name: str, *, given: bool = False, first: int = 1, last: int = 1) -> BehaviorCandidates:
    function = Function("f1", "negation", "plain", first, last, 5.0, "negation_word", given=given)
    movement = Movement(name, first, last, 5.0, "show_negation", "f1")
    return BehaviorCandidates(function, (Alternative((movement,), 1.0, 1.0),))


def names(candidates: BehaviorCandidates) -> list[str]:
    heaviest = sorted(candidates.alternatives, key=lambda each: -each.weight)
    return [movement.name for each in heaviest for movement in each.movements]


def test_the_behaviour_that_shows_the_likeliest_family_weighs_most() -> None:
    (found,) = candidates_of(
        PLAYER, utterance("no not those"), Plan((moment("negation", "present", shares=(0.6, 0.4)),)), []
    )
    assert names(found) == ["wipe", "open_hand", "away"]
    assert {each.movements[0].stroke for each in found.alternatives} == {1}
    rules = {each.movements[0].name: each.movements[0].rule for each in found.alternatives}
    assert rules == {
        "wipe": "gesture_family_negation",
        "away": "gesture_family_negation",
        "open_hand": "gesture_family_present",
    }


def test_a_weighed_gesture_has_no_substitute_that_says_much_less_of_what_is_meant() -> None:
    choice = ChoiceModel(
        ("negation", "present"), np.zeros(2, np.float32), 1.0, {}, np.zeros((0, 2), np.float32), 0.4, {}, {}
    )
    columns = {"NEGATION": 0, "DISMISS": 1, "OPEN_HAND": 2}
    shown = np.array([[1, 0], [0.5, 0], [0, 1]], np.float32)
    even, none = np.full((3, 2), 0.5, np.float32), np.zeros((3, 3), np.float32)
    behind = np.tile(np.array([0, 0.9 * LEAST_BEHIND, 1.1 * LEAST_BEHIND], np.float32), (3, 1))
    worths = LineWorths(choice, columns, shown, even, (frozenset(),) * 3, even, {}, none[:, 0], none, -behind)
    asked = moment("negation", "present", shares=(0.6, 0.4))
    (found,) = candidates_of(PLAYER, utterance("no not those"), Plan((asked,), worths), [])
    assert names(found) == ["wipe", "away"]


def test_a_mime_is_offered_where_its_lemma_is_and_not_elsewhere() -> None:
    asked = moment("emblem_other", "present", shares=(0.6, 0.3))
    (found,) = candidates_of(PLAYER, utterance("you drink it"), Plan((asked,)), [])
    assert names(found)[0] == "drink"
    (found,) = candidates_of(PLAYER, utterance("you see it"), Plan((asked,)), [])
    assert names(found) == ["open_hand"]


@pytest.mark.parametrize(("text", "triggered"), [("see it fall", {"wipe"}), ("see it go", set[str]())])
def test_a_word_is_named_as_a_trigger_only_where_it_stands(text: str, triggered: set[str]) -> None:
    """Though the behaviour is listed for any words as well."""
    twice = (FamilyBehavior("wipe"), FamilyBehavior("away"), FamilyBehavior("wipe", frozenset(["fall"])))
    families = replace(FAMILIES, gesture=MappingProxyType({"negation": twice}))
    asked = moment("negation", shares=(0.6,))
    (found,) = candidates_of(Player(families, BEHAVIORS), utterance(text), Plan((asked,)), [])
    (*made,) = (each.movements[0] for each in found.alternatives)
    assert {each.name for each in made if ASKED_BY_LEMMA in each.decided_by} == triggered


def test_a_thing_that_nobody_places_is_pointed_at_as_is_listed_first() -> None:
    pointings = {
        "point_there": (FamilyBehavior("open_hand"), FamilyBehavior("away")),
        "point_here": (FamilyBehavior("wipe"),),
    }
    shows = dict.fromkeys(FAMILIES.shows, ("point_there",))
    families = replace(FAMILIES, gesture=MappingProxyType(pointings), shows=MappingProxyType(shows))
    asked = moment("point", shares=(0.6,))
    (found,) = candidates_of(Player(families, BEHAVIORS), utterance("see that tower"), Plan((asked,)), [])
    assert names(found)[0] == "open_hand"
    assert USUAL_POINTING in found.alternatives[0].movements[0].decided_by


def test_what_a_rule_offers_for_these_words_goes_before_its_equals_and_names_rule_and_function() -> None:
    asked = moment("negation", shares=(0.6,))
    (found,) = candidates_of(PLAYER, utterance("no not those"), Plan((asked,)), [offer("wipe")])
    best = max(found.alternatives, key=lambda each: each.weight).movements[0]
    assert (best.name, best.rule, best.function, best.moment) == ("wipe", "show_negation", "f1", asked.id)
    assert [part.name for part in best.decided_by] == ["priority 5 of negation"]


def test_a_rule_that_the_plan_of_the_head_has_counted_is_named_once_and_the_largest_part_first() -> None:
    counted = (Term("rule show_negation, above average", 1.1), Term("reading in context: nod", -0.1))
    nodded = Moment("moment.head.nod.0", Channel.HEAD, 0, 2, 1, ("nod",), 0.7, (0.7,), counted)
    (found,) = candidates_of(PLAYER, utterance("yes of course"), Plan((nodded,)), [offer("nod")])
    (movement,) = found.alternatives[0].movements
    assert [part.name for part in movement.decided_by] == ["priority 5 of negation", "reading in context: nod"]


def test_a_function_is_named_only_for_what_its_rule_offers() -> None:
    asked = moment("negation", shares=(0.6,))
    (found,) = candidates_of(PLAYER, utterance("no not those"), Plan((asked,)), [offer("open_hand")])
    functions = {each.movements[0].name: each.movements[0].function for each in found.alternatives}
    assert functions == {"wipe": None, "away": None}


def test_what_is_banned_on_its_words_is_no_candidate() -> None:
    asked = moment("negation", shares=(0.6,))
    player = Player(FAMILIES, BEHAVIORS, bans=(Ban(2, 5, frozenset({"wipe"}), "never"),))
    (found,) = candidates_of(player, utterance("no not those"), Plan((asked,)), [offer("wipe")])
    assert names(found) == ["away"]


def test_rules_keep_the_channels_that_nobody_plans_and_lose_the_others() -> None:
    found = candidates_of(PLAYER, utterance("no not those"), Plan(), [offer("glance"), offer("nod"), offer("wipe")])
    assert [names(each) for each in found] == [["glance"]]


def test_a_function_that_the_caller_gave_is_shown_as_its_rule_says() -> None:
    (found,) = candidates_of(PLAYER, utterance("no not those"), Plan(), [offer("wipe", given=True)])
    assert names(found) == ["wipe"]


def test_a_moment_of_the_head_is_shown_by_its_kind_alone() -> None:
    nodded = Moment("moment.head.nod.0", Channel.HEAD, 0, 2, 1, ("nod",), 0.7, (0.7,))
    (found,) = candidates_of(PLAYER, utterance("yes of course"), Plan((nodded,)), [offer("wipe")])
    assert names(found) == ["nod"]
