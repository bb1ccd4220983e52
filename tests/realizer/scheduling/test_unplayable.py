"""What the body cannot do is told."""

import pytest

from tests.support.motion.movements import behavior, schedule
from understudy.behavior.characters.overlays import Characters
from understudy.model import Channel
from understudy.realizer.scheduling.unplayable import unplayable_behaviors
from understudy.resources import resource_folder


@pytest.mark.parametrize(
    ("kind", "lexeme", "direction", "action"),
    [
        (Channel.HEAD, "NOD", None, None),
        (Channel.HEAD, "ROLL_EYES", None, "dropped"),
        (Channel.POSTURE, "LEAN_BACK", None, None),
        (Channel.POSTURE, "HANDS_FOLDED", None, None),
        (Channel.POSTURE, "SITTING", None, "dropped"),
        (Channel.GAZE, "LOOK", "UPLEFT", None),
        (Channel.GAZE, "LOOK", "POLAR", "replaced"),
    ],
)
def test_what_has_no_movement_is_told(kind: Channel, lexeme: str, direction: str | None, action: str | None) -> None:
    told = unplayable_behaviors(schedule(behavior(kind, lexeme, 1.0, 1.8, 2.0, 2.8, direction=direction)))
    assert [decision.action for decision in told] == ([] if action is None else [action])


def test_every_movement_of_our_own_table_is_played() -> None:
    characters = Characters.load(resource_folder("lexicon"))
    entries = [entry for name in characters.by_name for entry in characters.named(name).entries.values()]
    ours = [behavior(entry.channel, entry.lexeme, 1.0, 2.0, direction=entry.direction) for entry in entries]
    assert unplayable_behaviors(schedule(*ours)) == ()


def test_a_shift_of_too_little_time_is_told() -> None:
    (told,) = unplayable_behaviors(schedule(behavior(Channel.POSTURE, "LEAN_LEFT", 1.0, 1.3)))
    assert (told.action, told.reason) == ("prolonged", "a shift of the body takes 0.6 s, not 0.30 s")


def test_a_target_that_is_nowhere_is_told_unless_it_is_the_other_in_the_talk() -> None:
    door, listener = (behavior(Channel.GAZE, "LOOK", 1.0, 1.2, 2.0, 2.2, target=name) for name in ("door", "listener"))
    (told,) = unplayable_behaviors(schedule(door, listener))
    assert (told.behavior, told.action) == (door.id, "replaced")
    assert unplayable_behaviors(schedule(door, listener), targets_m={"door": (1.0, 1.0, 1.0)}) == ()
    assert unplayable_behaviors(schedule(door)) == ()


def test_repetitions_that_there_is_no_time_for_are_told() -> None:
    hurried = behavior(Channel.HEAD, "NOD", 1.0, 1.5, repetitions=6)
    assert [(each.action, each.reason) for each in unplayable_behaviors(schedule(hurried))] == [
        ("shortened", "there is time for 2 of 6 repetitions")
    ]


def test_what_lost_is_not_told() -> None:
    assert unplayable_behaviors(schedule(behavior(Channel.HEAD, "ROLL_EYES", 1.0, 2.0, kept=False))) == ()
