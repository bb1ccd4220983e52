"""Waves that have no time for all of their swings."""

import pytest

from understudy.model import Hand, Level
from understudy.models import load_gestures
from understudy.realizer.gestures.waves import last_swing, waves

NAMES = ("GREETING", "FAREWELL")


@pytest.mark.parametrize("category", NAMES)
def test_of_a_raised_hand_the_last_swing_is_whole_and_still_a_wave(category: str) -> None:
    for clip in load_gestures().clips(category, Level.MEDIUM, Hand.RIGHT):
        assert waves(clip)
        swing, marks = last_swing(clip), clip.markers
        assert waves(swing)
        assert swing.markers.stroke_start == marks.stroke_start
        assert swing.markers.stroke_end - swing.markers.stroke_start < 0.5 * (marks.stroke_end - marks.stroke_start)
        assert swing.markers.stroke_start <= swing.markers.stroke <= swing.markers.stroke_end
        turns = [key for key in clip.keys if key.time_s < marks.stroke_end]
        begins = next(key for key in swing.keys if key.time_s == marks.stroke_start)
        assert begins.right is not None
        assert turns[-1].right is not None
        assert begins.right.place == turns[-1].right.place
        assert begins.right.hand is not None


def test_two_open_arms_do_not_wave() -> None:
    assert not any(map(waves, load_gestures().clips("GREETING", Level.MEDIUM, Hand.BOTH)))
