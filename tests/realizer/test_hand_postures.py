"""Hands go to and from where a posture has them without going through the body, on everybody's body."""

import pytest

from understudy.model import Behavior, Channel, Hand, Level, Manner, Schedule, SyncPoints
from understudy.models import load_realizer
from understudy.realizer.body.contacts import penetrations_m
from understudy.realizer.realizing import Realizer, realize
from understudy.realizer.scheduling.rests import POSTURES

DEEPEST_M = 0.01
DURATION_S = 6.0


@pytest.fixture(scope="module")
def realizer() -> Realizer:
    return load_realizer()


def gesture(lexeme: str, stroke_s: float, hand: Hand) -> Behavior:
    sync = SyncPoints(max(0.0, stroke_s - 0.6), stroke=stroke_s, relax=stroke_s + 0.4, end=stroke_s + 1.2)
    return Behavior(f"{lexeme}{stroke_s}", Channel.GESTURE, lexeme, sync, 0, 0, 1.0, hand=hand)


def posture(lexeme: str, start_s: float) -> Behavior:
    return Behavior("posture", Channel.POSTURE, lexeme, SyncPoints(start_s, start_s + 0.7), 0, 0, 1.0)


@pytest.mark.parametrize("character", ["default", "expansive", "formal_elder", "reserved"])
@pytest.mark.parametrize("lexeme", [lexeme for lexeme, pose in POSTURES.items() if pose])
@pytest.mark.parametrize(("posture_s", "hand"), [(0.0, Hand.RIGHT), (0.0, Hand.BOTH), (2.2, Hand.LEFT)])
def test_hands_do_not_go_through_the_body(
    realizer: Realizer, character: str, lexeme: str, posture_s: float, hand: Hand
) -> None:
    """The first stroke comes so early that the hand is on its way to it in the first frame."""
    asked = (gesture("COUNT_TWO", 0.45, hand), posture(lexeme, posture_s), gesture("QUESTION", 4.4, hand))
    schedule = Schedule(asked, DURATION_S, agitation=Level.HIGH, character=character)
    body, skeleton = realize(realizer, schedule).body, realizer.performer(character).skeleton
    assert penetrations_m(skeleton, body.rotations, body.hips_m).max() <= DEEPEST_M


def test_arms_that_fold_after_a_gesture_do_not_go_through_each_other(realizer: Realizer) -> None:
    """One hand comes from its gesture and the other from the side, both at the end: with the usual time to blend in
    what keeps them apart, one stays 2.8 cm inside the other."""
    sync = SyncPoints(4.552, 6.655, 5.082, 5.082, 5.699, 5.964, 6.105)
    closer = Behavior("gesture3", Channel.GESTURE, "COME_CLOSER", sync, 0, 0, 8.0, hand=Hand.RIGHT, amount=0.3)
    asked = (posture("HANDS_FOLDED", 4.408), closer)
    assert_clear(realizer, Schedule(asked, 6.785, agitation=Level.LOW, character="reserved"), seed=1)


def test_an_elbow_that_a_gesture_draws_into_the_belly_comes_out(realizer: Realizer) -> None:
    """Turned about the line from shoulder to wrist alone it stays 2.3 cm inside."""
    sync = SyncPoints(0.0, 1.6, 0.05, 0.48, 0.48, 1.0, 1.0)
    drink = Behavior("gesture1", Channel.GESTURE, "MIME_DRINK", sync, 0, 0, 2.0, hand=Hand.LEFT, amount=0.0)
    assert_clear(realizer, Schedule((drink,), 2.0, character="expansive"), seed=3)


def test_hands_that_fold_go_to_the_side_on_which_they_rest(realizer: Realizer) -> None:
    """On the side on which they meet first one stays 3.2 cm inside the other."""
    walk, hush, throw = (
        Behavior(lexeme, Channel.GESTURE, lexeme, sync, 0, 0, priority, hand=hand, amount=amount)
        for lexeme, sync, priority, hand, amount in (
            ("MIME_WALK", SyncPoints(0.0, 6.0, 1.09, 3.0, 5.29, 5.85, 6.0), 2.0, None, 1.0),
            ("MIME_HUSH", SyncPoints(0.0, 5.44, 0.15, 1.48, 3.0, 3.15, 3.72), 3.0, Hand.BOTH, None),
            ("MIME_THROW", SyncPoints(0.15, 6.0, 0.15, 2.19, 3.15, 4.5, 6.0), 3.0, Hand.LEFT, None),
        )
    )
    asked = (walk, hush, posture("HANDS_FOLDED", 4.5), throw)
    assert_clear(realizer, Schedule(asked, 6.0, agitation=Level.HIGH), seed=2)


def test_what_is_left_of_a_hand_inside_the_other_is_left_again(realizer: Realizer) -> None:
    """One hand goes to be folded as the other says no: in the best way, at one go, it stays 2 cm inside."""
    sync = SyncPoints(1.055, 2.882, 1.505, 1.505, 1.938, 2.123, 2.352)
    manner = Manner(amplitude=0.99, speed=1.0, tension=0.82)
    no = Behavior("gesture1", Channel.GESTURE, "NEGATION", sync, 0, 0, 8.6, hand=Hand.RIGHT, amount=0.3, manner=manner)
    asked = (no, posture("HANDS_FOLDED", 1.216))
    assert_clear(realizer, Schedule(asked, 3.335, agitation=Level.LOW, character="reserved"), seed=2)


def assert_clear(realizer: Realizer, schedule: Schedule, *, seed: int) -> None:
    motion, skeleton = realize(realizer, schedule, seed=seed), realizer.performer(schedule.character).skeleton
    assert penetrations_m(skeleton, motion.body.rotations, motion.body.hips_m).max() <= DEEPEST_M
    assert "kept" not in {told.action for told in motion.decisions}
