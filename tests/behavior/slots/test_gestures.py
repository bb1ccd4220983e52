"""What the words of lines say, and which gestures get it."""

from dataclasses import replace

import pytest

from tests.behavior.candidates.test_demands import spoken
from tests.support.motion.gesture_clips import gesture
from understudy.behavior.slots.gestures import slots_of, slots_said, with_slots
from understudy.model import Channel, Moment, Slots
from understudy.models import Understudy


def slots(understudy: Understudy, text: str, first: int, last: int, *listeners: str) -> Slots:
    analysis, table = spoken(understudy, text), understudy.behavior.slots
    return slots_of(table, slots_said(table, analysis.utterance, analysis.functions, listeners), first, last)


def test_a_child_is_lower_than_one_who_is_taller_than_the_speaker(understudy: Understudy) -> None:
    child = slots(understudy, "You were this tall the last time I saw you.", 2, 3)
    taller = slots(understudy, "Look at you, you're taller than me now.", 4, 6)
    assert child.height_m is not None
    assert taller.height_m is not None
    assert child.height_m < 1.2
    assert taller.height_m > 1.7


def test_who_towers_over_somebody_is_tall_and_a_tower_over_there_is_not(understudy: Understudy) -> None:
    tall = slots(understudy, "Her sons tower over me.", 2, 4)
    tower = slots(understudy, "See that tower over there?", 1, 4)
    assert tall.height_m is not None
    assert tall.height_m > 1.7
    assert tower.height_m is None
    assert tower.distance is not None


def test_a_length_in_units_is_kept(understudy: Understudy) -> None:
    assert slots(understudy, "It was ten feet high.", 2, 4).height_m == pytest.approx(3.048)
    assert slots(understudy, "The cut was two centimeters long.", 3, 5).size_m == pytest.approx(0.02)


@pytest.mark.parametrize(
    ("text", "first", "second"),
    [
        ("Do you want this one or that one?", (3, 4), (6, 7)),
        ("On the one hand it's cheap, on the other hand it's ugly.", (0, 3), (6, 9)),
        ("On the left, the king. On the right, the thief.", (0, 2), (5, 7)),
    ],
)
def test_contrasted_things_are_on_opposite_sides(
    understudy: Understudy, text: str, first: tuple[int, int], second: tuple[int, int]
) -> None:
    sides = [slots(understudy, text, *words).side for words in (first, second)]
    assert sides == ["left", "right"]


def test_a_thing_keeps_its_place_and_another_of_its_name_has_its_own(understudy: Understudy) -> None:
    text = "The wall on your left is old, the wall on your right is new. That wall burned."
    old, new, last = (slots(understudy, text, *words) for words in ((0, 4), (7, 11), (14, 15)))
    assert (old.referent, old.side) == ("wall", "right")
    assert (new.referent, new.side) == ("wall_2", "left")
    assert (last.referent, last.side) == ("wall_2", "left")


@pytest.mark.parametrize(
    ("text", "word", "listener"),
    [
        ("Sit down, Tom.", 0, "tom"),
        ("You stay here, Anna, and you come with me, Tom.", 0, "anna"),
        ("You stay here, Anna, and you come with me, Tom.", 5, "tom"),
        ("I gave the letter to Anna.", 1, None),
        ("I gave the letter to Anna.", 5, "anna"),
    ],
)
def test_who_is_called_by_name_has_the_words_of_the_clause(
    understudy: Understudy, text: str, word: int, listener: str | None
) -> None:
    assert slots(understudy, text, word, word, "anna", "tom").listener == listener


def test_the_listener_named_last_is_addressed(understudy: Understudy) -> None:
    text = "Tom, you stay. Anna, come with you."
    assert slots(understudy, text, 1, 1, "anna", "tom").listener == "tom"
    assert slots(understudy, text, 6, 6, "anna", "tom").listener == "anna"
    assert slots(understudy, text, 1, 1).listener is None


def test_a_gesture_has_only_slots_that_it_can_show(understudy: Understudy) -> None:
    analysis = spoken(understudy, "There are four doors on the left.")
    names = ("COUNT_FOUR", "POINT_LEFT", "BEAT")
    given = [replace(gesture(name, 0.0, 1.0, lexeme=name), first=0, last=6) for name in names]
    count, point, beat = with_slots(given, analysis, (), understudy.behavior.slots)
    assert count.slots == Slots(count=4)
    assert point.slots is not None
    assert (point.slots.side, point.slots.count) == ("left", None)
    assert beat.slots is None


def test_nothing_but_gestures_has_slots(understudy: Understudy) -> None:
    analysis = spoken(understudy, "There are four doors on the left.")
    turn = replace(gesture("h1", 0.0, 1.0, lexeme="POINT_LEFT"), kind=Channel.HEAD, last=6)
    assert with_slots((turn,), analysis, (), understudy.behavior.slots) == (turn,)


def test_a_gesture_that_places_one_side_of_a_contrast_is_on_that_side(understudy: Understudy) -> None:
    analysis = spoken(understudy, "The shop is on the left.")
    place = replace(gesture("g1", 0.0, 1.0, lexeme="PLACE_RIGHT"), last=5)
    (placed,) = with_slots((place,), analysis, (), understudy.behavior.slots)
    assert placed.slots is not None
    assert placed.slots.side == "right"


@pytest.mark.parametrize(("lexeme", "shown"), [("LEFT", "RIGHT"), ("POINT_LEFT", "POINT_RIGHT"), ("RIGHT", "RIGHT")])
def test_a_gesture_to_a_side_goes_to_the_side_of_who_speaks(understudy: Understudy, lexeme: str, shown: str) -> None:
    analysis = spoken(understudy, "The wall on your left is old.")
    sided = replace(gesture("g1", 0.0, 1.0, lexeme=lexeme), last=4)
    (placed,) = with_slots((sided,), analysis, (), understudy.behavior.slots)
    assert placed.lexeme == shown


def test_a_gesture_that_a_note_asks_for_stays_what_it_is(understudy: Understudy) -> None:
    analysis = spoken(understudy, "The wall on your left is old.")
    note = Moment("m1", Channel.GESTURE, 2, 4, 4, ("left",), 1.0, note=0)
    asked = replace(gesture("g1", 0.0, 1.0, lexeme="LEFT"), last=4, moment="m1")
    (placed,) = with_slots((asked,), analysis, (note,), understudy.behavior.slots)
    assert placed.lexeme == "LEFT"


def test_a_gesture_whose_own_words_say_nothing_shows_what_is_said_near_its_stroke(understudy: Understudy) -> None:
    analysis = spoken(understudy, "There was only a tiny crack in the glass.")
    narrow = replace(gesture("g1", 0.0, 1.0, lexeme="PINCH"), moment="only", first=2, last=2)
    only = Moment("only", Channel.GESTURE, 2, 2, 2, ("size_small",), 0.5)
    crack = replace(only, id="crack", first=4, last=5, stroke=5)
    alone, beside = (
        with_slots((narrow,), analysis, moments, understudy.behavior.slots)[0] for moments in ((only,), (only, crack))
    )
    assert alone.slots is not None
    assert alone.slots.size == "tiny"
    assert beside.slots is None
