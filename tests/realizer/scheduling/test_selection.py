"""Requests out of BML, and the clips that fit them."""

from dataclasses import replace
from math import inf

import numpy as np
import pytest

from tests.support.motion.gesture_clips import clip, gesture, library
from understudy.model import Hand, Level, Manner, Schedule, SyncPoints
from understudy.realizer.scheduling.selection import (
    candidate_clips,
    fits,
    fits_without_hold,
    in_the_time,
    place_clip,
    requests_of,
    shuffled,
)


@pytest.mark.parametrize(
    ("sync", "stroke_s", "relax_s"),
    [
        (SyncPoints(1.0, 3.0, stroke_start=1.4, stroke=1.8, stroke_end=2.0, relax=2.5), 1.8, 2.5),
        (SyncPoints(1.0, 3.0, stroke_start=1.4, stroke=1.8, stroke_end=2.0), 1.8, 2.0),
        (SyncPoints(1.0, 3.0, stroke_start=1.4, stroke_end=2.0), 2.0, 2.0),
        (SyncPoints(1.0, 3.0, stroke_start=1.4), 1.4, 3.0),
        (SyncPoints(1.0, 3.0), 1.0, 3.0),
    ],
)
def test_bml_that_leaves_points_out_still_makes_a_request(sync: SyncPoints, stroke_s: float, relax_s: float) -> None:
    (request,) = requests_of(Schedule((replace(gesture("g1", 2.0, 2.5), sync=sync),), 4.0))
    assert (request.stroke_s, request.relax_s) == (stroke_s, relax_s)


def test_requests_are_those_of_kept_gestures_in_order_of_their_strokes() -> None:
    lost = replace(gesture("lost", 1.0, 1.5), kept=False)
    requests = requests_of(Schedule((gesture("g2", 3.0, 3.5), lost, gesture("g1", 2.0, 2.5)), 5.0))
    assert [request.behavior for request in requests] == ["g1", "g2"]


@pytest.mark.parametrize(("amount", "size"), [(None, 1.0), (0.5, 1.0), (0.125, 0.5)])
def test_hands_go_as_far_as_the_root_of_the_amount(amount: float | None, size: float) -> None:
    (request,) = requests_of(Schedule((gesture("g1", 2.0, 2.5, amount=amount),), 4.0))
    assert request.size == pytest.approx(size)


def test_the_manner_scales_the_size() -> None:
    (request,) = requests_of(Schedule((replace(gesture("g1", 2.0, 2.5), manner=Manner(amplitude=1.3)),), 4.0))
    assert request.size == pytest.approx(1.3)


def test_a_slow_manner_is_played_where_there_is_time_and_left_out_where_there_is_none() -> None:
    manner = Manner(speed=0.8)
    (roomy,) = requests_of(Schedule((replace(gesture("g1", 2.0, 4.0), manner=manner),), 6.0))
    (tight,) = requests_of(Schedule((replace(gesture("g1", 2.0, 2.12), manner=manner),), 6.0))
    usual = clip().markers.stroke_end - clip().markers.stroke_start
    slow, kept = (in_the_time(clip(), replace(each, longest_stroke_s=inf)) for each in (roomy, tight))
    assert slow.markers.stroke_end - slow.markers.stroke_start == pytest.approx(usual / 0.8)
    assert kept.markers.stroke_end - kept.markers.stroke_start == pytest.approx(usual)


@pytest.mark.parametrize("amount", [0.5, 0.9])
def test_all_gestures_of_a_still_body_are_smaller_by_one_factor(amount: float) -> None:
    """Also those that would be too fast, which are not made as large as they are asked to be."""
    fast = replace(clip(), stroke_speed_m_s=1.2)
    (lively,) = requests_of(Schedule((gesture("g1", 2.0, 2.5, amount=amount),), 4.0))
    (still,) = requests_of(Schedule((gesture("g1", 2.0, 2.5, amount=0.36 * amount),), 4.0, stillness=0.64))
    assert place_clip(fast, still).size == pytest.approx(0.6 * place_clip(fast, lively).size)


@pytest.mark.parametrize(
    ("left_s", "whole", "without_hold"), [(0.31, True, True), (0.29, False, True), (0.09, False, False)]
)
def test_eq_5_with_and_without_the_hold(left_s: float, whole: bool, without_hold: bool) -> None:
    """.4 s from stroke to relax, .2 s from stroke to stroke end, .1 s forgiven."""
    (request,) = requests_of(Schedule((gesture("g1", 2.0, 2.0 + left_s),), 4.0))
    assert (fits(clip(), request), fits_without_hold(clip(), request)) == (whole, without_hold)


def test_a_gesture_made_by_another_hand_or_at_another_level_only_stands_in() -> None:
    calm = replace(clip("both", hand=Hand.BOTH), level=Level.LOW)
    (request,) = requests_of(Schedule((gesture("g1", 2.0, 2.5),), 4.0, agitation=Level.HIGH))
    (found,), (decision,) = candidate_clips(request, library(calm))
    assert found is calm
    assert decision.action == "replaced"
    assert "both hands" in decision.reason
    assert "low replaces it" in decision.reason


def test_the_variant_used_last_comes_last_and_the_others_as_drawn() -> None:
    clips = tuple(clip(name) for name in ("one", "two", "three"))
    orders = {tuple(c.name for c in shuffled(clips, "two", np.random.default_rng(seed))) for seed in range(20)}
    assert orders == {("one", "three", "two"), ("three", "one", "two")}
