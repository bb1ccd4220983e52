"""A clip in a manner is as much faster and as much tenser as it is asked to be."""

import pytest

from tests.support.motion.gesture_clips import clip
from understudy.model import Manner
from understudy.realizer.gestures.mannered import mannered


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
