"""Brief strokes, on every gesture of the library."""

from itertools import pairwise

import numpy as np
import pytest

from tests.support.motion.gesture_clips import clip
from understudy.model import Hand, Level, Manner
from understudy.model.limits import brief_share
from understudy.models import load_gestures, load_realizer
from understudy.realizer.arms.wrist_paths import relax_m, stroke_end_m, stroke_start_m
from understudy.realizer.gestures.brief_strokes import brief, last_swing, mannered
from understudy.realizer.gestures.gesture import Clip, Markers
from understudy.realizer.gestures.gesture_plan import GestureRequest, PlacedGesture

LIBRARY = load_gestures()


def placed(clip: Clip) -> PlacedGesture:
    return PlacedGesture(GestureRequest("g1", clip.category, 5.0, 6.0, 1.0, clip.hand), clip, 6.0)


def clips() -> list[Clip]:
    return [clip for name in LIBRARY.categories for clip in LIBRARY.clips(name, Level.MEDIUM, Hand.RIGHT)]


@pytest.mark.parametrize("clip", clips(), ids=lambda clip: f"{clip.category} {clip.name}")
def test_a_brief_stroke_has_the_last_part_of_the_way_in_that_part_of_the_time(clip: Clip) -> None:
    share = brief_share(clip.markers.stroke_end - clip.markers.stroke_start)
    made, whole = placed(brief(clip)), placed(clip)
    stroke_s = made.clip.markers.stroke_end - made.clip.markers.stroke_start
    assert stroke_s == pytest.approx(share * (clip.markers.stroke_end - clip.markers.stroke_start))
    for arm in (clip.hand,):
        end_m = stroke_end_m(whole, arm)
        assert stroke_end_m(made, arm) == pytest.approx(end_m)
        assert relax_m(made, arm) == pytest.approx(relax_m(whole, arm))
        way_m = np.linalg.norm(stroke_start_m(made, arm) - end_m)
        assert way_m <= share * np.linalg.norm(stroke_start_m(whole, arm) - end_m) + 1e-6


def test_what_surrounds_the_stroke_lasts_as_long() -> None:
    clip = next(each for each in clips() if each.category == "NEGATION")
    lasts = [
        {names: getattr(each, names[1]) - getattr(each, names[0]) for names in pairwise(Markers.__slots__)}
        for each in (clip.markers, brief(clip).markers)
    ]
    in_stroke = {("stroke_start", "stroke"), ("stroke", "stroke_end")}
    for names, whole_s in lasts[0].items():
        assert lasts[1][names] == pytest.approx(0.5 * whole_s if names in in_stroke else whole_s, abs=0.02)
    times_s = [key.time_s for key in brief(clip).keys]
    assert times_s == sorted(times_s)


def test_the_usual_manner_changes_nothing() -> None:
    assert mannered(clip(), Manner(amplitude=1.4)) == clip()


@pytest.mark.parametrize("speed", [0.8, 1.25])
def test_speed_shortens_all_phases_alike(speed: float) -> None:
    usual, made = clip(), mannered(clip(), Manner(speed=speed))
    assert made.markers.stroke_end == pytest.approx(usual.markers.stroke_end / speed)
    assert [key.time_s for key in made.keys] == pytest.approx([key.time_s / speed for key in usual.keys])
    assert made.stroke_speed_m_s == pytest.approx(usual.stroke_speed_m_s * speed)


def test_tension_gives_power_and_takes_fluidity_within_bounds() -> None:
    usual = clip().expressivity
    tense, lax = (mannered(clip(), Manner(tension=tension)).expressivity for tension in (1.4, 0.6))
    assert tense.power > usual.power > lax.power
    assert tense.fluidity < usual.fluidity < lax.fluidity
    assert mannered(clip(), Manner(tension=9)).expressivity.fluidity >= 0
    assert mannered(clip(), Manner(tension=9)).expressivity.power == 1


WAVING = ("GREETING", "FAREWELL")


@pytest.mark.parametrize("category", WAVING)
def test_of_a_raised_hand_the_last_swing_is_whole_and_still_a_wave(category: str) -> None:
    for wave in load_realizer().library.clips(category, Level.MEDIUM, Hand.RIGHT):
        assert wave.waves
        swing, marks = last_swing(wave), wave.markers
        assert swing.waves
        assert swing.markers.stroke_start == marks.stroke_start
        assert swing.markers.stroke_end - swing.markers.stroke_start < 0.5 * (marks.stroke_end - marks.stroke_start)
        assert swing.markers.stroke_start <= swing.markers.stroke <= swing.markers.stroke_end
        turns = [key for key in wave.keys if key.time_s < marks.stroke_end]
        begins = next(key for key in swing.keys if key.time_s == marks.stroke_start)
        assert begins.right is not None
        assert turns[-1].right is not None
        assert begins.right.place == turns[-1].right.place
        assert begins.right.hand is not None


def test_two_open_arms_do_not_wave() -> None:
    assert not any(each.waves for each in load_realizer().library.clips("GREETING", Level.MEDIUM, Hand.BOTH))


def test_only_what_movement_yaml_lists_waves() -> None:
    library = load_realizer().library
    assert {
        each.category
        for category in library.categories
        for each in library.clips(category, Level.MEDIUM, Hand.RIGHT)
        if each.waves
    } == set(WAVING)
    assert not any(each.waves for each in library.with_waves(()).clips("GREETING", Level.MEDIUM, Hand.RIGHT))
