"""One gesture played alone."""

import numpy as np
import pytest

from tests.support.motion.gesture_files import gesture
from understudy.authoring.gesture_playing import BEFORE_S, BEHAVIOR, Playing, schedule_of_gesture, with_only
from understudy.authoring.gesture_texts import one_gesture
from understudy.errors import InputError
from understudy.model import Hand, Level
from understudy.models import Understudy
from understudy.realization import realize_prepared
from understudy.realizer.body.skeleton import forward

RAISED = gesture(last="FRAMETYPE stroke_end\n  ARM XC YUpperP ZMiddle", name="raised")
SIDES = ("left", "right")


@pytest.mark.parametrize("hand", [Hand.LEFT, Hand.RIGHT])
def test_the_hand_that_is_asked_for_goes_where_the_gesture_says(understudy: Understudy, hand: Hand) -> None:
    """At the stroke's end the wrist is at the height of the shoulders (`YUpperP`), the other hand at rest below.

    At rest it is as high as in the first frame but for 5 cm. Around a gesture alone hands rest before the belly and do
    not hang: the other wrist is 13 cm below (26 cm where the right hand gestures), so that 20 cm cannot be asked.
    """
    definition = one_gesture(RAISED, None)
    playing = Playing(hand=hand)
    realizer = with_only(understudy.realizer, definition, playing)
    realized = realize_prepared(realizer, schedule_of_gesture(definition, playing), frame_rate_hz=30)
    sync = realized.motion.realized[BEHAVIOR]
    assert sync.stroke_end is not None
    body, skeleton = realized.motion.body, realizer.skeleton
    frame = int(np.searchsorted(body.times_s, sync.stroke_end))
    places, _turns = forward(skeleton, body.rotations[[0, frame]], body.hips_m[[0, frame]])
    before, heights = ({side: place[skeleton.index[f"{side}Hand"], 1] for side in SIDES} for place in places)
    other = "left" if hand is Hand.RIGHT else "right"
    assert heights[hand] == pytest.approx(places[1, skeleton.index[f"{hand}UpperArm"], 1], abs=0.06)
    assert heights[other] == pytest.approx(before[other], abs=0.05)
    assert heights[other] < heights[hand] - 0.1


def test_the_gesture_takes_the_time_of_its_level() -> None:
    definition = one_gesture(RAISED, None)
    lasting = {level: schedule_of_gesture(definition, Playing(level)).schedule.behaviors[0].sync for level in Level}
    tempo = {level: definition.levels[level].tempo for level in Level}
    for level, sync in lasting.items():
        assert sync.start == BEFORE_S
        assert sync.end - sync.start == pytest.approx(0.75 * definition.duration_s / tempo[level])


def test_a_level_that_it_does_not_suit_is_refused() -> None:
    with pytest.raises(InputError, match="not for low agitation, but for high") as caught:
        schedule_of_gesture(one_gesture(gesture("LEVELS high"), None), Playing(Level.LOW))
    assert caught.value.code == "unfit_gesture"
