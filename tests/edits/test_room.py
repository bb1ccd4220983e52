"""Making room for edited behaviours."""

from dataclasses import replace

from understudy.edits.room import SettledBehavior, with_room
from understudy.model import Behavior, Channel, Hand, SyncPoints


def _gesture(name: str, start_s: float, *, hand: Hand = Hand.RIGHT) -> Behavior:
    """.4 s of preparation, .5 s of stroke, .5 s of hold, .5 s of retraction."""
    points = (0.0, 0.4, 0.4, 0.7, 0.9, 1.4, 1.9)
    start, ready, stroke_start, stroke, stroke_end, relax, end = (round(start_s + each, 3) for each in points)
    sync = SyncPoints(start, end, ready, stroke_start, stroke, stroke_end, relax)
    return Behavior(name, Channel.GESTURE, name.upper(), sync, 0, 0, 5.0, hand=hand)


def _settled(authored: Behavior, *others: Behavior, free: bool = True) -> dict[str, Behavior]:
    settled = with_room([SettledBehavior(authored, free)], others, lambda _gesture: ())
    return {each.id: each for each in settled}


def test_what_comes_before_gives_up_its_retraction_and_its_hold() -> None:
    found = _settled(_gesture("mine", 1.1), _gesture("other", 0.0))
    assert found["mine"] == _gesture("mine", 1.1)
    assert (found["other"].sync.relax, found["other"].sync.end) == (1.1, 1.1)
    assert found["other"].reason == "shortened beside MINE"


def test_what_comes_after_begins_later_and_has_the_retraction_before_it() -> None:
    found = _settled(_gesture("mine", 0.0), _gesture("other", 1.2))
    assert found["mine"].sync.end == 1.6
    assert found["other"].sync.start == 1.6
    assert found["other"].sync.stroke == _gesture("other", 1.2).sync.stroke


def test_a_retraction_that_was_asked_for_stays() -> None:
    found = _settled(_gesture("mine", 0.0), _gesture("other", 1.2), free=False)
    assert found["mine"] == _gesture("mine", 0.0)
    assert not found["other"].kept
    assert found["other"].lost_to == "mine"


def test_what_has_no_time_for_its_stroke_goes_and_says_why() -> None:
    found = _settled(_gesture("mine", 0.5), _gesture("other", 0.2))
    assert not found["other"].kept
    assert found["other"].reason == "too close to MINE, which the author put there"


def test_the_other_hand_goes_on() -> None:
    other = _gesture("other", 0.2, hand=Hand.LEFT)
    assert _settled(_gesture("mine", 0.5), other)["other"] == other


def test_a_look_aside_goes_on_with_the_eyes_alone_while_the_head_moves() -> None:
    head = replace(_gesture("nod", 0.5), kind=Channel.HEAD, hand=None)
    sync = SyncPoints(0.6, 1.5, ready=0.8, relax=1.2)
    look = Behavior("look", Channel.GAZE, "LOOK", sync, 0, 0, 3.0, direction="LEFT", amount=0.4, target="listener")
    found = _settled(head, look)["look"]
    assert (found.kept, found.lexeme, found.sync) == (True, "GLANCE", sync)


def test_of_two_edits_the_first_stands() -> None:
    settled = with_room(
        [SettledBehavior(_gesture("first", 0.5), True), SettledBehavior(_gesture("second", 0.6), True)],
        (),
        lambda _gesture: (),
    )
    assert [(each.id, each.kept) for each in settled] == [("first", True), ("second", False)]
