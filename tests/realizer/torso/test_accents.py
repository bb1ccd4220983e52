"""With each stroke the trunk goes along and comes back."""

import numpy as np
import pytest

from understudy.model import FloatArray, Hand
from understudy.realizer.body.movement_style import StrokeLife
from understudy.realizer.torso.trunk import AHEAD_S, RECOVERY_S, Accent, accent_course

TIMES_S: FloatArray = np.arange(301) / 60
LIFE = StrokeLife(dip_m=0.01, bow_deg=4.0, twist_deg=3.0, shoulders_deg=2.0, weight_m=0.015, neck_deg=5.0)


def at(time_s: float) -> int:
    return round(time_s * 60)


@pytest.mark.parametrize(("side", "sign"), [(Hand.RIGHT, 1.0), (Hand.LEFT, -1.0)])
def test_the_trunk_strikes_with_the_hand_and_recovers(side: Hand, sign: float) -> None:
    """The striking hand's shoulder comes forward and down, the weight goes to its side, the knees give way."""
    course = accent_course(TIMES_S, [Accent(2.0, 2.5, 1.0, side)], LIFE, scale=1.0)
    struck = at(2.5)
    assert np.degrees(course.turns[struck]) == pytest.approx([4.0, 3.0 * sign, 2.0 * sign])
    assert (course.dip_m[struck], course.aside_m[struck]) == pytest.approx((0.01, -0.015 * sign))
    assert np.degrees(course.neck[struck]) == pytest.approx(5.0)
    for still in (at(2.0 - AHEAD_S) - 1, at(2.5 + RECOVERY_S) + 1):
        assert np.abs(course.turns[still]).max() == pytest.approx(0.0, abs=1e-9)
    assert course.dip_m[at(2.0)] > 0


def test_strokes_add_up_and_stillness_takes_them_away() -> None:
    strokes = [Accent(1.0, 1.3, 0.5, Hand.RIGHT), Accent(1.2, 1.6, 0.7, Hand.LEFT)]
    both = accent_course(TIMES_S, strokes, LIFE, scale=1.0)
    each = [accent_course(TIMES_S, [one], LIFE, scale=1.0) for one in strokes]
    assert both.dip_m == pytest.approx(each[0].dip_m + each[1].dip_m)
    assert np.abs(accent_course(TIMES_S, strokes, LIFE, scale=0.0).turns).max() == 0


def test_without_strokes_nothing_is_added() -> None:
    assert np.abs(accent_course(TIMES_S, [], LIFE, scale=1.0).turns).max() == 0
