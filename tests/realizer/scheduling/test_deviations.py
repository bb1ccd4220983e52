"""What the body cannot do is told."""

import pytest

from tests.support.motion.movements import behavior, schedule
from understudy.behavior.characters.overlays import Characters
from understudy.files import resource_folder
from understudy.model import Behavior, Channel, Hand, Schedule, SyncPoints
from understudy.models import load_realizer
from understudy.realizer.body.motion import Decision
from understudy.realizer.realizing import realize
from understudy.realizer.scheduling.deviations import timing_deviations, unplayable_behaviors


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


def test_coordinates_that_cannot_be_read_are_not_taken_for_the_other() -> None:
    (told,) = unplayable_behaviors(schedule(behavior(Channel.GAZE, "LOOK", 1.0, 1.2, 2.0, 2.2, target="1,1")))
    assert told.reason == "'1,1' has no position: the gaze goes to the listener"


def test_repetitions_that_there_is_no_time_for_are_told() -> None:
    hurried = behavior(Channel.HEAD, "NOD", 1.0, 1.5, repetitions=6)
    assert [(each.action, each.reason) for each in unplayable_behaviors(schedule(hurried))] == [
        ("shortened", "there is only time for 2 of 6 repetitions")
    ]


def test_what_lost_is_not_told() -> None:
    assert unplayable_behaviors(schedule(behavior(Channel.HEAD, "ROLL_EYES", 1.0, 2.0, kept=False))) == ()


ASKED = Behavior("g1", Channel.GESTURE, "BEAT", SyncPoints(1.0, 3.0, stroke=1.95), 0, 0, 1.0, hand=Hand.RIGHT)


def test_a_beat_from_1_to_3_is_played_from_1_to_3() -> None:
    """The hand takes its time on both ways; nothing is left to tell."""
    schedule = Schedule((ASKED,), 4.0, asked={"g1": frozenset({"start", "end"})})
    motion = realize(load_realizer(), schedule, frame_rate_hz=30)
    made = motion.realized["g1"]
    assert (made.start, made.end) == pytest.approx((1.0, 3.0), abs=1e-6)
    assert [each for each in motion.decisions if each.action == "timed"] == []


def test_what_hands_cannot_do_in_the_time_is_told_with_both_times() -> None:
    asked = Behavior("g1", Channel.GESTURE, "BEAT", SyncPoints(1.0, 1.15, stroke=1.1), 0, 0, 1.0, hand=Hand.RIGHT)
    schedule = Schedule((asked,), 4.0, asked={"g1": frozenset({"start", "stroke", "end"})})
    motion = realize(load_realizer(), schedule, frame_rate_hz=30)
    made = motion.realized["g1"]
    assert made.stroke == pytest.approx(1.1)
    (told,) = (each for each in motion.decisions if each.action == "timed")
    reason = f"begins at {made.start:.2f} s, not at 1.00 s; ends at {made.end:.2f} s, not at 1.15 s"
    assert told == Decision("g1", "timed", reason)


@pytest.mark.parametrize(
    ("made", "decided", "told"),
    [
        (SyncPoints(1.04, 2.96), None, []),
        (SyncPoints(1.1, 3.0), None, ["begins at 1.10 s, not at 1.00 s"]),
        (SyncPoints(0.9, 3.2), None, ["begins at 0.90 s, not at 1.00 s; ends at 3.20 s, not at 3.00 s"]),
        (SyncPoints(0.9, 3.2), "held", ["begins at 0.90 s, not at 1.00 s"]),
        (SyncPoints(1.2, 3.2), "blended", ["ends at 3.20 s, not at 3.00 s"]),
        (SyncPoints(1.2, 3.2), "dropped", []),
    ],
)
def test_what_is_told_is_not_told_twice(made: SyncPoints, decided: str | None, told: list[str]) -> None:
    decisions = [Decision("g1", decided, "why")] if decided else []
    assert [each.reason for each in timing_deviations([ASKED], {"g1": made}, decisions, {})] == told


def test_points_that_a_document_states_are_told_though_decisions_hint_at_them() -> None:
    asked = Behavior("g1", Channel.GESTURE, "BEAT", SyncPoints(1.0, 3.0, stroke_end=1.8, relax=2.0), 0, 0, 1.0)
    made = SyncPoints(1.0, 3.2, stroke_end=1.7, relax=2.4)
    stated = {"g1": frozenset({"start", "relax", "end"})}
    (told,) = timing_deviations([asked], {"g1": made}, [Decision("g1", "held", "why")], stated)
    assert told.reason == "relaxes at 2.40 s, not at 2.00 s; ends at 3.20 s, not at 3.00 s"
