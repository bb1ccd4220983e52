"""Strokes that snap: as long a way in less time, around the same emphasis."""

from dataclasses import replace

import numpy as np
import pytest

from tests.support.motion.gesture_clips import clip, place
from understudy.model import Hand, Manner
from understudy.realizer.arms.wrist_paths import distance_m, stroke_end_m, stroke_start_m
from understudy.realizer.body.movement_style import Strokes
from understudy.realizer.dynamics.snapping import lifted, quickened, snapped, wound_up
from understudy.realizer.gestures.brief_strokes import mannered
from understudy.realizer.gestures.gesture import ArmKey
from understudy.realizer.gestures.gesture_plan import GestureRequest, PlacedGesture

FAST = Strokes(speed_m_s=(0.6, 1.2, 1.2), fastest_m_s=(1.5, 1.5, 1.5), wind_up=(1.5,) * 3, longest_m=(0.4,) * 3)


def placed(to_m: float = 0.3, category: str = "GREETING") -> PlacedGesture:
    return PlacedGesture(GestureRequest("g1", category, 2.0, 2.6, 1.0), clip(to_m=to_m, category=category), 2.6)


def stroke_s(gesture: PlacedGesture) -> float:
    return gesture.stroke_end_s - gesture.stroke_start_s


def test_a_stroke_is_as_fast_as_is_asked_for_around_its_emphasis() -> None:
    """.3 m in .5 s is .6 m/s: at 1.2 m/s it takes half the time, .6 of it before the emphasis as before."""
    made = snapped(placed(), FAST, np.random.default_rng(0))
    assert stroke_s(made) == pytest.approx(0.25)
    assert made.stroke_start_s == pytest.approx(2.0 - 0.15)
    assert made.clip.markers.ready == placed().clip.markers.ready
    assert made.clip.stroke_speed_m_s == placed().clip.stroke_speed_m_s


def test_strokes_are_of_many_lengths_and_none_is_shorter_than_a_hand_can() -> None:
    varied = replace(FAST, variety=(0.6, 2.0), shortest_s=0.25)
    lengths = [stroke_s(snapped(placed(), varied, np.random.default_rng(seed))) for seed in range(40)]
    assert len({round(each, 2) for each in lengths}) > 10
    assert min(lengths) >= 0.17


@pytest.mark.parametrize(
    ("gesture", "style"),
    [
        (placed(to_m=0.9), replace(FAST, speed_m_s=(0.9, 0.9, 0.9))),
        (placed(category="SLOW"), replace(FAST, unhurried=("SLOW",))),
        (placed(to_m=0.03), FAST),
        (placed(), Strokes()),
    ],
    ids=["fast already", "slow by its meaning", "of the fingers alone", "nothing asked for"],
)
def test_what_is_not_to_be_quickened_stays(gesture: PlacedGesture, style: Strokes) -> None:
    assert snapped(gesture, style, np.random.default_rng(0)) is gesture


def test_a_hand_that_comes_back_in_its_stroke_takes_its_time() -> None:
    """A circle or a stroke to and fro would be lost in less time; one that goes on, over a key on its way, is not."""
    plain = placed()
    before, after = plain.clip.keys[0], plain.clip.keys[-1]

    def over(out_m: float) -> PlacedGesture:
        between = replace(before, time_s=0.75, right=ArmKey(place(out_m)))
        return replace(plain, clip=replace(plain.clip, keys=(before, between, after)))

    assert stroke_s(snapped(over(0.2), FAST, np.random.default_rng(0))) < stroke_s(over(0.2))
    assert snapped(over(1.0), FAST, np.random.default_rng(0)) == over(1.0)


def test_a_short_stroke_begins_farther_from_where_it_ends() -> None:
    short = placed(to_m=0.1)
    drawn_back = wound_up(short, FAST)
    ways_m = [
        distance_m(stroke_start_m(each, Hand.RIGHT), stroke_end_m(each, Hand.RIGHT)) for each in (short, drawn_back)
    ]
    assert ways_m == pytest.approx([0.1, 0.15])
    assert np.allclose(stroke_end_m(short, Hand.RIGHT), stroke_end_m(drawn_back, Hand.RIGHT))


def as_the_voice_has_it(manner: Manner, to_m: float = 0.1) -> PlacedGesture:
    """The gesture in a manner, as it is placed for a request: its size in the request, its speed in the clip."""
    plain = placed(to_m)
    request = replace(plain.request, manner=manner, size=plain.request.size * manner.amplitude)
    return replace(plain, request=request, clip=mannered(plain.clip, manner))


def test_what_the_voice_makes_bigger_is_drawn_back_farther_and_what_it_makes_small_is_not() -> None:
    def way_m(amplitude: float) -> float:
        drawn_back = wound_up(as_the_voice_has_it(Manner(amplitude, 1.0, 1.0)), FAST)
        return distance_m(stroke_start_m(drawn_back, Hand.RIGHT), stroke_end_m(drawn_back, Hand.RIGHT))

    assert way_m(1.2) > 1.2 * way_m(1.0)
    assert way_m(0.5) == pytest.approx(0.05)


def test_the_speed_of_the_voice_is_still_seen_in_a_stroke_that_snaps() -> None:
    """The usual stroke is quickened, by the same share as it would be in any manner."""
    lengths = [
        stroke_s(snapped(as_the_voice_has_it(Manner(1.0, speed, 1.0), 0.3), FAST, np.random.default_rng(0)))
        for speed in (0.8, 1.0, 1.1)
    ]
    assert lengths == pytest.approx([lengths[1] / 0.8, lengths[1], lengths[1] / 1.1])


def test_gestures_are_higher_as_the_level_has_it_and_not_at_the_head() -> None:
    style = Strokes(lift_m=(0.0, 0.05, 0.1))
    up_m = stroke_end_m(lifted(placed(), style), Hand.RIGHT) - stroke_end_m(placed(), Hand.RIGHT)
    assert up_m == pytest.approx([0.0, 0.05, 0.0])


def test_only_the_stroke_of_a_quickened_clip_takes_less_time() -> None:
    before, after = clip().markers, quickened(clip(), 0.5).markers
    assert after.stroke_end - after.stroke_start == pytest.approx(0.5 * (before.stroke_end - before.stroke_start))
    assert after.end - after.relax == pytest.approx(before.end - before.relax)
