"""Which words name a target, and the movements on them."""

import pytest

from tests.support.words.utterances import utterance
from understudy.behavior.candidates.targets import mentions, pointing_candidates, without_overlapped
from understudy.model import BehaviorCandidates, Channel, Function, Moment, Target, Utterance

DOOR = Target("door", (1.2, 1.4, 2.0))
FRONT_DOOR = Target("front_door", (0.0, 1.4, 2.0))


def line(text: str, tags: str) -> Utterance:
    """The words of `text`, a token each, with their parts of speech."""
    spelt = [
        f"{number}:{word.strip(',.')}/{word.strip(',.').lower().removesuffix('s')}/{tag}"
        for number, (word, tag) in enumerate(zip(text.split(), tags.split(), strict=True))
    ]
    return utterance(text, " ".join(spelt))


@pytest.mark.parametrize(
    ("text", "tags", "found"),
    [
        ("Close the door.", "VERB DET NOUN", [(1, 2)]),
        ("Close the old red door.", "VERB DET ADJ ADJ NOUN", [(1, 4)]),
        ("That door or this Door.", "DET NOUN CCONJ DET NOUN", [(0, 1), (3, 4)]),
        ("The door, the door, that door.", "DET NOUN DET NOUN DET NOUN", [(0, 1), (4, 5)]),
        ("All of those doors.", "DET ADP DET NOUN", [(2, 3)]),
        ("My door.", "PRON NOUN", [(0, 1)]),
        ("A door is a door.", "DET NOUN AUX DET NOUN", []),
        ("The man saw door.", "DET NOUN VERB NOUN", []),
        ("Doors are the thing.", "NOUN AUX DET NOUN", []),
    ],
)
def test_a_noun_that_is_known_by_its_article_names_the_target(
    text: str, tags: str, found: list[tuple[int, int]]
) -> None:
    assert [(each.first, each.last) for each in mentions(line(text, tags), [DOOR])] == found


def test_names_of_several_words_and_of_persons() -> None:
    found = mentions(line("The front door, Anna.", "DET ADJ NOUN PROPN"), [FRONT_DOOR, Target("anna", (0, 1.6, 1))])
    assert [(each.target.name, each.first, each.last) for each in found] == [("front_door", 0, 2), ("anna", 3, 3)]


def test_where_two_targets_fit_the_longer_name_wins() -> None:
    (only,) = mentions(line("The front door.", "DET NOUN NOUN"), [DOOR, FRONT_DOOR])
    assert only.target is FRONT_DOOR


@pytest.mark.parametrize(
    ("x_m", "behavior"),
    [(1.0, "gesture_point_left"), (0.1, "gesture_point_front"), (-1.0, "gesture_point_right")],
)
def test_the_hand_of_its_side_points_and_the_eyes_look_on_the_noun(x_m: float, behavior: str) -> None:
    target = Target("door", (x_m, 1.0, 2.0))
    deixis = Function("f2", "deixis", "distal", 1, 2, 3.0, "by_hand")
    other = Function("f1", "emphasis", "plain", 2, 2, 9.0, "by_hand")
    (offer,) = pointing_candidates(mentions(line("See that door.", "VERB DET NOUN"), [target]), [other, deixis])
    (alternative,) = offer.alternatives
    assert [movement.name for movement in alternative.movements] == [behavior, "gaze_target"]
    assert {(movement.target, movement.stroke, movement.function) for movement in alternative.movements} == {
        ("door", 2, "f2")
    }


def test_what_would_point_elsewhere_on_those_words_is_left_out() -> None:
    named = mentions(line("See that door.", "VERB DET NOUN"), [DOOR])
    (pointing,) = pointing_candidates(named)
    elsewhere = Function("f1", "deixis", "distal", 1, 2, 3.0, "by_hand")
    offers = [
        BehaviorCandidates(elsewhere, pointing.alternatives),
        BehaviorCandidates(Function("f2", "negation", "plain", 1, 1, 3.0, "by_hand"), pointing.alternatives),
        BehaviorCandidates(None, (), Moment("m1", Channel.GESTURE, 2, 2, 2, ("beat",), 0.5)),
        BehaviorCandidates(None, (), Moment("m2", Channel.HEAD, 2, 2, 2, ("nod",), 0.5)),
        BehaviorCandidates(None, (), Moment("m3", Channel.GESTURE, 2, 2, 2, ("beat",), 0.5, note=0)),
    ]
    assert without_overlapped(offers, named) == (offers[1], offers[3], offers[4])
