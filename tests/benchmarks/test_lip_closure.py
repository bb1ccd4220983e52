"""The measure of closures, on faces made by hand."""

import numpy as np
import pytest

from benchmarks.realizer.face.lip_closure import SHUT, lip_closures, lip_opening
from understudy.model import FloatArray, Interval, Viseme
from understudy.realizer.body.motion import SHAPES
from understudy.realizer.face.face_tables import INDEX

TIMES_S = np.arange(0, 1, 0.01)


def mouth(**weights: float | FloatArray) -> FloatArray:
    shapes = np.zeros((len(TIMES_S), len(SHAPES)))
    for name, weight in weights.items():
        shapes[:, INDEX[name]] = weight
    return shapes


def closed(start_s: float, end_s: float) -> FloatArray:
    """A jaw that stays open behind lips that are shut for so long."""
    shut = (start_s - 1e-9 < TIMES_S) & (end_s + 1e-9 > TIMES_S)
    return mouth(jawOpen=0.3, mouthClose=np.where(shut, 0.3, 0.0))


def said(label: str, start_s: float, end_s: float) -> tuple[Viseme, ...]:
    return (Viseme("aa", Interval(0, start_s), 1, 1), Viseme(label, Interval(start_s, end_s), 1, 0))


def test_lips_that_close_the_jaws_opening_are_shut() -> None:
    assert lip_opening(mouth(jawOpen=0.4, mouthClose=0.4)).max() == 0
    assert lip_opening(mouth(jawOpen=0.4, mouthClose=0.1)).min() == pytest.approx(0.3)
    assert lip_opening(mouth(mouthFunnel=0.5)).min() > SHUT


def test_a_raised_upper_lip_parts_the_lips_but_not_the_lower_from_the_teeth() -> None:
    sneer = mouth(mouthUpperUpLeft=0.5, mouthUpperUpRight=0.5)
    assert lip_opening(sneer).min() > SHUT
    assert lip_opening(sneer, to_teeth=True).max() == 0


@pytest.mark.parametrize("label", ["PP", "FF"])
def test_the_time_of_a_closure_is_found(label: str) -> None:
    [closure] = lip_closures(said(label, 0.4, 0.5), closed(0.38, 0.47), TIMES_S)
    assert closure.closed is not None
    assert closure.closed.start_s == pytest.approx(0.38, abs=0.01)
    assert closure.closed.end_s == pytest.approx(0.47, abs=0.01)


def test_a_closure_outside_its_phone_is_none() -> None:
    [closure] = lip_closures(said("PP", 0.4, 0.5), closed(0.6, 0.7), TIMES_S)
    assert closure.closed is None


def test_a_mouth_that_never_opens_is_shut_from_the_first_frame_to_the_last() -> None:
    [closure] = lip_closures(said("PP", 0.4, 0.5), mouth(), TIMES_S)
    assert closure.closed == Interval(0, TIMES_S[-1])


def test_other_visemes_want_no_closure() -> None:
    assert lip_closures(said("DD", 0.4, 0.5), mouth(), TIMES_S) == ()
