"""Ways between neighbours, by the arithmetic of §3.8."""

from itertools import pairwise

import pytest

from tests.support.motion.gesture_clips import clip, gesture
from understudy.model import Hand, Interval, Schedule
from understudy.model.figure import Wait
from understudy.model.limits import EASY_TRANSITION_S, SLOWEST_STROKE_M_S, TOP_STROKE_SPEED_M_S
from understudy.realizer.body.movement_style import MovementStyle, Waits
from understudy.realizer.gestures.gesture import Clip
from understudy.realizer.gestures.gesture_plan import PlacedGesture
from understudy.realizer.scheduling.selection import place_clip, requests_of
from understudy.realizer.scheduling.transitions import (
    TransitionContext,
    blends,
    prolonged_relax_s,
    stroke_speed_m_s,
    way_m,
)


def at(stroke_s: float, relax_s: float, one: Clip | None = None, amount: float | None = None) -> PlacedGesture:
    (request,) = requests_of(Schedule((gesture("g", stroke_s, relax_s, amount=amount),), 30.0))
    return place_clip(one or clip(), request)


def test_a_way_leads_from_where_the_hand_relaxes_to_where_the_next_stroke_starts() -> None:
    """Back over the .3 m of the stroke."""
    assert way_m(at(2.0, 2.5), at(3.3, 3.8), Hand.RIGHT) == pytest.approx(0.3)


@pytest.mark.parametrize(("stroke_s", "hold_s"), [(3.2, 0.0), (3.3, 0.0), (3.5, 0.2), (4.3, 1.0)])
def test_the_hold_lasts_until_the_way_is_as_fast_as_the_stroke(stroke_s: float, hold_s: float) -> None:
    """.3 m at .6 m/s take .5 s; the gap begins at 2.5 s and ends .3 s before the stroke."""
    relax_s = prolonged_relax_s(at(2.0, 2.5), at(stroke_s, stroke_s + 0.5), Hand.RIGHT)
    assert relax_s == pytest.approx(2.5 + hold_s)


def test_a_hand_that_is_in_place_still_takes_a_moment() -> None:
    first, second = at(2.0, 2.5), at(3.8, 4.3, clip(from_m=0.3, to_m=0.6))
    assert prolonged_relax_s(first, second, Hand.RIGHT) == pytest.approx(3.5 - EASY_TRANSITION_S)


def test_strokes_of_the_fingers_alone_count_as_slow() -> None:
    assert stroke_speed_m_s(at(2.0, 2.5, clip(to_m=0.0))) == SLOWEST_STROKE_M_S


def test_a_stroke_is_as_large_as_its_time_allows() -> None:
    """.4 m in .5 s, twice as large for an amount of 2: .8 m/s become 1.6, more than the top speed."""
    large = at(2.0, 2.5, clip(to_m=0.4), amount=2.0)
    assert stroke_speed_m_s(large) == pytest.approx(TOP_STROKE_SPEED_M_S)
    assert large.size == pytest.approx(TOP_STROKE_SPEED_M_S / 0.8)


def test_neighbours_flow_together_in_one_phrase_below_a_second_and_a_half() -> None:
    first = at(2.0, 2.5, clip(to_m=0.1))
    near, far = at(4.29, 4.8), at(4.31, 4.8)
    one, two = TransitionContext((Interval(0.0, 9.0),)), TransitionContext((Interval(0.0, 3.0), Interval(3.3, 9.0)))
    assert blends(first, near, Hand.RIGHT, one)
    assert not blends(first, far, Hand.RIGHT, one)
    assert not blends(first, near, Hand.RIGHT, two)
    assert blends(first, at(3.3, 3.8), Hand.RIGHT, two)


@pytest.mark.parametrize(("time_s", "phrase"), [(0.0, 0), (0.5, 0), (2.5, 0), (3.0, 1), (9.0, 1)])
def test_a_moment_belongs_to_the_phrase_that_has_begun_last(time_s: float, phrase: int) -> None:
    assert TransitionContext((Interval(0.2, 2.0), Interval(3.0, 4.0))).phrase_of(time_s) == phrase
    assert TransitionContext().phrase_of(time_s) is None


def test_singletons_rest_between_neighbours_as_soon_as_hands_can() -> None:
    """To the side and back at 1.25 m/s, where hands that take their time would stay in the unit."""
    first = at(2.0, 2.5, clip(to_m=0.1))
    one = (Interval(0.0, 9.0),)
    second = at(4.2, 4.7)
    assert blends(first, second, Hand.RIGHT, TransitionContext(one))
    assert not blends(first, second, Hand.RIGHT, TransitionContext(one, singletons=True))
    assert blends(first, at(3.0, 3.5), Hand.RIGHT, TransitionContext(one, singletons=True)), "no time at all"


def test_hands_wait_another_way_each_time_by_the_seed() -> None:
    gestures = [at(2.0 + 3 * number, 2.5 + 3 * number) for number in range(40)]
    style = MovementStyle(waits=Waits(belly=(1, 1, 1), one=(1, 1, 1), hip=(0, 1, 1)))
    ways = [TransitionContext(style=style, seed=seed).waits(gestures) for seed in (1, 2)]
    for found in ways:
        assert all(one is not other for one, other in pairwise(found))
        assert set(found) == {Wait.BELLY, Wait.ONE, Wait.HIP}
    assert ways[0] != ways[1]


def test_characters_keep_to_their_own_ways_of_waiting() -> None:
    waits = Waits(belly=(1, 1, 1), one=(2, 1, 0)).only((Wait.ONE, Wait.OPEN))
    assert waits.weights(0) == {Wait.ONE: 2.0, Wait.OPEN: 1.0}
    assert waits.weights(2) == {Wait.OPEN: 1.0}
