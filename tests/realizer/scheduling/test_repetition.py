"""Strokes repeated on further emphases."""

from dataclasses import replace

import numpy as np
import pytest

from tests.support.motion.gesture_clips import clip, gesture, library
from understudy.model import Hand, Schedule
from understudy.model.slots import Side, Slots
from understudy.realizer.body.movement_style import Holds
from understudy.realizer.gestures.gesture import Expressivity
from understudy.realizer.gestures.gesture_plan import ArmGesture, GestureRequest, PlacedGesture, Repeat
from understudy.realizer.scheduling.planning import plan_gestures
from understudy.realizer.scheduling.repetition import (
    beside_a_wave,
    is_held_long,
    let_go_in_time,
    most_repeats,
    with_beats,
    with_repeats,
)
from understudy.realizer.scheduling.selection import place_clip, requests_of


def struck(category: str = "BEAT", repetition: float = 0.0) -> PlacedGesture:
    """Stroke end at 2.2 s, relax at 2.5 s."""
    (request,) = requests_of(Schedule((gesture("g", 2.0, 2.5, lexeme=category),), 30.0))
    return place_clip(clip(category=category, expressivity=Expressivity(repetition=repetition)), request)


def next_to(wave: PlacedGesture, stroke_s: float, slots: Slots | None = None) -> GestureRequest:
    """A gesture of the same hand with its emphasis at that time."""
    return replace(wave.request, behavior="next", category="COME_CLOSER", stroke_s=stroke_s, slots=slots)


def test_what_follows_a_wave_at_once_is_made_with_the_other_hand() -> None:
    """ "Hello! Come on in." """
    wave = struck("GREETING")
    waving = replace(wave, clip=replace(wave.clip, waves=True))
    soon, later = next_to(wave, wave.stroke_start_s + 1.2), next_to(wave, wave.stroke_start_s + 1.8)
    made, decisions = beside_a_wave(soon, [waving])
    assert made.hand is Hand.LEFT
    assert [(each.behavior, each.action) for each in decisions] == [("next", "replaced")]
    assert beside_a_wave(later, [waving]) == (later, ())
    assert beside_a_wave(soon, [wave]) == (soon, ())


def test_what_shows_a_place_stays_with_its_hand_though_that_waves() -> None:
    wave = struck("GREETING")
    placed = next_to(wave, wave.stroke_start_s + 1.2, slots=Slots(side=Side.RIGHT))
    assert beside_a_wave(placed, [replace(wave, clip=replace(wave.clip, waves=True))]) == (placed, ())


def test_a_place_is_seen_before_the_hand_beats() -> None:
    """A beat begins .35 s after the stroke has ended at 2.2 s at the earliest."""
    plain = struck()
    shown = replace(plain, request=replace(plain.request, slots=Slots(side=Side.RIGHT)))
    assert [each.end_s for each in with_repeats(plain, [2.6, 3.0], 9.0).repeats] == [2.6, 3.0]
    [beat] = with_repeats(shown, [2.6, 3.0], 9.0).repeats
    assert beat.end_s == 3.0
    assert beat.start_s >= 2.2 + 0.35


@pytest.mark.parametrize(
    ("emphases_s", "until_s", "ends_s"),
    [
        ([], 9.0, []),
        ([2.0, 2.2, 2.5], 9.0, []),
        ([2.6], 9.0, [2.6]),
        ([3.0, 2.6], 9.0, [2.6, 3.0]),
        ([2.6, 2.8, 3.0], 9.0, [2.6, 3.0]),
        ([2.6, 3.0, 3.4], 9.0, [2.6, 3.0]),
        ([2.6, 3.0], 2.9, [2.6]),
        ([3.8], 9.0, []),
        ([2.6, 4.2], 9.0, [2.6]),
    ],
)
def test_emphases_count_that_are_neither_too_soon_nor_too_late(
    emphases_s: list[float], until_s: float, ends_s: list[float]
) -> None:
    repeats = with_repeats(struck(), emphases_s, until_s).repeats
    assert [repeat.end_s for repeat in repeats] == ends_s
    assert [repeat.amplitude for repeat in repeats] == [0.6, 0.4][: len(ends_s)]
    assert all(repeat.start_s < repeat.end_s for repeat in repeats)


def test_the_hold_follows_the_last_repetition() -> None:
    assert with_repeats(struck(), [2.6], 9.0).relax_s == pytest.approx(2.7)
    assert with_repeats(struck(), [], 9.0).relax_s == 2.5
    assert with_repeats(struck(), [2.6], 2.65).relax_s == 2.65


@pytest.mark.parametrize(
    ("asked_s", "until_s", "ends_s"),
    [
        ((), 9.0, []),
        ((0.5, 1.0), 9.0, [2.7, 3.2]),
        ((0.2, 0.6), 9.0, [2.8]),
        ((0.5, 1.0), 3.0, [2.7]),
        ((0.5, 1.0, 1.5, 2.0), 9.0, [2.7, 3.2, 3.7, 4.2]),
    ],
)
def test_strokes_that_are_asked_for_are_made_and_no_others(
    asked_s: tuple[float, ...], until_s: float, ends_s: list[float]
) -> None:
    placed = struck(repetition=1.0)
    asked = replace(placed, request=replace(placed.request, after_strokes_s=asked_s))
    repeats = with_repeats(asked, [2.6, 3.0], until_s).repeats
    assert [repeat.end_s for repeat in repeats] == pytest.approx(ends_s)
    assert [repeat.amplitude for repeat in repeats] == pytest.approx([0.6, 0.4, 0.25, 0.1625][: len(ends_s)])


def test_strokes_that_a_following_gesture_leaves_no_time_for_are_told() -> None:
    """As those of a rheme, whose every emphasis is asked for."""
    first = replace(gesture("g", 2.0, 2.5, lexeme="BEAT"), after_strokes_s=(0.2, 0.6, 1.2, 3.0))
    second = gesture("h", 4.6, 5.2, lexeme="BEAT")
    plan = plan_gestures(library(clip(category="BEAT")), Schedule((first, second), 9.0), seed=0)
    (reason,) = [each.reason for each in plan.decisions if (each.behavior, each.action) == ("g", "repeated")]
    again, left, soon = reason.split("; ")
    assert again == "strokes again on the emphases at 2.80, 3.40 s"
    assert left == "not at 5.20 s, as asked: the arm has left by then"
    assert soon == "not at 2.40 s, as asked: that is too soon after the stroke before"


@pytest.mark.parametrize(
    ("category", "repetition", "most"),
    [("GREETING", 0.0, 0), ("GREETING", 0.4, 1), ("GREETING", 1.0, 3), ("BEAT", 0.0, 2), ("BEAT", 1.0, 3)],
)
def test_how_often_is_the_expressivitys_to_say(category: str, repetition: float, most: int) -> None:
    assert most_repeats(struck(category, repetition)) == most


HOLDS = Holds(longest_s=1.0, way_m=(0.15, 0.25), spacing_s=(0.8, 0.8))


def held_until(relax_s: float) -> ArmGesture:
    (arm,) = plan_gestures(library(clip()), Schedule((gesture("g", 2.0, relax_s),), 9.0), seed=0).gestures
    return arm


def beats(relax_s: float, emphases_s: tuple[float, ...] = (), lag_s: float = 0.0) -> list[Repeat]:
    return list(with_beats(held_until(relax_s), emphases_s, HOLDS, np.random.default_rng(0), lag_s=lag_s).beats)


def test_a_long_hold_becomes_beats_that_show_each_smaller() -> None:
    """The stroke ends at 2.2 s: held for 2.4 s, with beats every .8 s, the last one not at the very end."""
    found = beats(4.6)
    assert [beat.end_s for beat in found] == pytest.approx([3.0, 3.8])
    assert [beat.way_m for beat in found] == pytest.approx([0.25, 0.15])
    assert all(beat.start_s < beat.end_s for beat in found)


def test_beats_fall_on_emphases_where_there_are_any() -> None:
    assert [beat.end_s for beat in beats(4.6, (2.3, 3.1, 3.2, 4.0))] == pytest.approx([3.1, 4.0])
    assert [beat.end_s for beat in beats(4.6, (3.1, 4.0), lag_s=0.08)] == pytest.approx([3.18, 4.08])


def test_a_short_hold_is_held() -> None:
    assert not is_held_long(held_until(3.1), HOLDS)
    assert is_held_long(held_until(4.6), HOLDS)


def test_a_body_that_is_to_be_still_lets_go_instead() -> None:
    assert let_go_in_time(held_until(4.6).placed, HOLDS).relax_s == pytest.approx(3.2)
