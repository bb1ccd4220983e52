"""Moving sync points: which others follow, and that the order is kept."""

from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from understudy.edits.timing import SettledBehavior, moved, place_s, with_room
from understudy.model import Behavior, Channel, Hand, Interval, SyncPoints, Word
from understudy.model.edits import MARKS, Edge, MarkPlace, WordReference

GESTURE = SyncPoints(start=1.0, ready=1.4, stroke_start=1.4, stroke=1.7, stroke_end=1.9, relax=2.4, end=2.9)
FACE = SyncPoints(start=1.0, ready=1.2, relax=2.0, end=2.3)
SHIFT = SyncPoints(start=1.0, ready=1.3, relax=1.3, end=1.3)
LINE_S = 10.0


def _moved(sync: SyncPoints, wanted_s: dict[str, float], *, lasting: bool = False) -> dict[str, float]:
    outcome = moved(sync, wanted_s, end_s=LINE_S, lasting=lasting)
    assert outcome.refused == ()
    return dict(outcome.sync.in_order())


@pytest.mark.parametrize("name", ["ready", "stroke_start", "stroke", "stroke_end"])
def test_a_stroke_is_never_stretched_but_takes_everything_with_it(name: str) -> None:
    later = _moved(GESTURE, {name: getattr(GESTURE, name) + 0.25})
    assert later == pytest.approx({each: at_s + 0.25 for each, at_s in GESTURE.in_order()})


@pytest.mark.parametrize(
    ("name", "later_s", "following"),
    [("start", -0.3, {"start"}), ("relax", 0.4, {"relax", "end"}), ("end", 0.6, {"end"})],
)
def test_preparation_hold_and_retraction_get_longer_or_shorter_alone(
    name: str, later_s: float, following: set[str]
) -> None:
    found = _moved(GESTURE, {name: getattr(GESTURE, name) + later_s})
    moved_s = {each: at_s + later_s for each, at_s in GESTURE.in_order() if each in following}
    assert found == pytest.approx(dict(GESTURE.in_order()) | moved_s)


def test_several_points_are_each_where_they_were_put() -> None:
    found = _moved(GESTURE, {"start": 0.5, "stroke": 2.0, "relax": 3.0, "end": 3.1})
    assert [found[name] for name in ("start", "stroke", "relax", "end")] == [0.5, 2.0, 3.0, 3.1]
    assert found["stroke_end"] - found["stroke_start"] == pytest.approx(0.5)


def test_what_has_no_stroke_moves_with_the_state_that_is_reached() -> None:
    assert _moved(FACE, {"ready": 3.2}) == pytest.approx({"start": 3.0, "ready": 3.2, "relax": 4.0, "end": 4.3})


def test_what_lasts_is_over_when_it_is_reached() -> None:
    found = _moved(SHIFT, {"end": 2.0}, lasting=True)
    assert (found["ready"], found["relax"], found["end"]) == (2.0, 2.0, 2.0)


@pytest.mark.parametrize(
    ("wanted_s", "refused"),
    [
        ({"start": 5.0}, ("start", 5.0)),
        ({"relax": 1.0}, ("relax", 1.0)),
        ({"end": 1.0}, ("end", 1.0)),
        ({"stroke": LINE_S + 1}, ("stroke", LINE_S + 1)),
        ({"stroke": 0.1}, ("stroke", 0.1)),
    ],
)
def test_a_point_that_cannot_be_there_is_told_and_goes_as_far_as_it_can(
    wanted_s: dict[str, float], refused: tuple[str, float]
) -> None:
    """A stroke of .3 s before its emphasis cannot have it at .1 s, nor behind the end of the line."""
    outcome = moved(GESTURE, wanted_s, end_s=LINE_S)
    assert outcome.refused == (refused,)
    times_s = [at_s for _name, at_s in outcome.sync.in_order()]
    assert times_s == sorted(times_s)


@given(st.dictionaries(st.sampled_from(MARKS), st.floats(-5, 15), max_size=7), st.sampled_from((GESTURE, FACE)))
def test_the_order_stays_whatever_is_asked(wanted_s: dict[str, float], sync: SyncPoints) -> None:
    times_s = [at_s for _name, at_s in moved(sync, wanted_s, end_s=LINE_S).sync.in_order()]
    assert times_s == sorted(times_s)
    assert times_s[0] >= 0


def test_a_moment_is_told_from_either_edge_of_a_word() -> None:
    words = (Word(0, "No,", Interval(0.5, 0.8)), Word(1, "—"))
    no = WordReference(0, "no")
    assert place_s(MarkPlace(no, 0.1), words) == pytest.approx(0.6)
    assert place_s(MarkPlace(no, -0.1, Edge.END), words) == pytest.approx(0.7)
    assert place_s(MarkPlace(WordReference(1), 0.1), words) is None


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
    assert found["other"].reason == "shortened to make room for MINE"


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
