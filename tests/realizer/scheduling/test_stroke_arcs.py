"""Strokes that are asked to be curved: how far the wrist goes beside the line, when, and which way."""

from dataclasses import replace

import numpy as np
import pytest

from tests.realizer.scheduling.test_gesture_controller import RATE_HZ, moved, planned, wrist
from tests.support.motion.gesture_clips import MARKERS, clip, gesture, library
from understudy.model import FloatArray, Hand
from understudy.realizer.gestures.gesture import Clip, OffsetTrack, TrackForm
from understudy.realizer.scheduling.stroke_arcs import ARC

STROKE_S = 2.0
BEGINS, ENDS = (
    round((STROKE_S + at_s - MARKERS.stroke) * RATE_HZ) for at_s in (MARKERS.stroke_start, MARKERS.stroke_end)
)


def wrists(played: Clip, side: str, *, curved: bool) -> FloatArray:
    """Where a wrist is (T, 3) in a gesture whose stroke leads .3 m outwards."""
    asked = replace(gesture("g", STROKE_S, 2.5, hand=played.hand), curved=curved)
    return wrist(moved(planned([asked], library(played))), side)


def added_m(played: Clip, side: str) -> FloatArray:
    """How far (T, 3) a wrist is from where it would be without the arc."""
    return wrists(played, side, curved=True) - wrists(played, side, curved=False)


@pytest.mark.parametrize("hand", Hand)
def test_the_wrist_is_beside_the_line_in_the_middle_of_the_stroke_and_in_its_place_at_both_ends(hand: Hand) -> None:
    for side in ("left", "right") if hand is Hand.BOTH else (hand,):
        way_m = wrists(clip(hand=hand), side, curved=False)[[BEGINS, ENDS]]
        beside_m = added_m(clip(hand=hand), side)
        length_m = float(np.linalg.norm(way_m[1] - way_m[0]))
        most = int(np.argmax(np.linalg.norm(beside_m, axis=1)))
        assert np.linalg.norm(beside_m[most]) == pytest.approx(ARC * length_m, rel=0.2)
        assert abs(most - (BEGINS + ENDS) / 2) <= 0.25 * RATE_HZ * (MARKERS.stroke_end - MARKERS.stroke_start)
        assert beside_m[most, 1] > 0.5 * np.linalg.norm(beside_m[most]), "a stroke to the side goes over the line"
        assert abs(beside_m[most] @ (way_m[1] - way_m[0])) < 0.2 * length_m * np.linalg.norm(beside_m[most])


def test_nothing_is_bent_outside_the_stroke_nor_in_the_other_arm() -> None:
    beside_m = added_m(clip(), "right")
    np.testing.assert_allclose(np.vstack((beside_m[: BEGINS - 1], beside_m[ENDS + 2 :])), 0, atol=1e-9)
    np.testing.assert_allclose(added_m(clip(), "left"), 0, atol=1e-9)


def test_a_stroke_of_the_wrist_alone_and_one_that_is_an_arc_already_stay_as_they_are() -> None:
    in_place = clip(from_m=0.1, to_m=0.1)
    np.testing.assert_allclose(added_m(in_place, "right"), 0, atol=1e-9)
    arc = replace(clip(), tracks=(OffsetTrack(TrackForm.CURVED, "UpperArm", (0.0, 0.0, 10.0)),))
    np.testing.assert_allclose(added_m(arc, "right"), 0, atol=1e-9)
