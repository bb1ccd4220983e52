"""Wrist speeds are those of the motion, and the picture of them is drawn."""

import numpy as np
import pytest

from tests.support.motion.hand_made_motion import BODY, Y, still, turned, waving
from understudy.model import Behavior, Channel, Hand, Interval, Schedule, Word
from understudy.realizer.geometry.rotations import from_axis_angle
from understudy.realizer.pictures.speed_plot import draw_speeds, wrist_speeds_m_s


def test_a_wrist_on_a_circle_has_the_circles_speed() -> None:
    radians_per_s = 2.0
    motion = turned("leftLowerArm", from_axis_angle(Y, -radians_per_s * np.arange(91) / 30), frames=91)
    speeds = wrist_speeds_m_s(motion, BODY)
    assert speeds[20:70, 0] == pytest.approx(radians_per_s * 0.25, rel=0.02)
    assert speeds[:, 1] == pytest.approx(0, abs=1e-9)


@pytest.mark.parametrize("frames", [1, 5, 40])
def test_a_body_that_stands_still_has_no_speed(frames: int) -> None:
    assert wrist_speeds_m_s(still(frames), BODY) == pytest.approx(np.zeros((frames, 2)), abs=1e-9)


def test_the_picture_is_png_whatever_is_known_of_the_words() -> None:
    pytest.importorskip("matplotlib", reason="pictures need matplotlib")
    motion = waving()
    wave = Behavior("wave1", Channel.GESTURE, "GREETING", motion.realized["wave1"], 0, 0, 1.0, hand=Hand.RIGHT)
    schedule = Schedule((wave,), 2.0, (Word(0, "Hello", Interval(0.2, 0.9)), Word(1, "there")))
    png = draw_speeds(motion, BODY, schedule)
    assert png.startswith(b"\x89PNG")
    without = draw_speeds(motion, BODY, Schedule((), 2.0))
    assert without.startswith(b"\x89PNG")
    assert without != png
