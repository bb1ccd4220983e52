"""A gesture's text: its mistakes with their places, or its definitions and doubts about them."""

import numpy as np
import pytest

from tests.support.motion.gesture_files import gesture
from understudy.authoring.gesture_texts import (
    BEFORE_S,
    BEHAVIOR,
    MOST_MISTAKES,
    Playing,
    check_text,
    one_gesture,
    schedule_of_gesture,
    with_only,
)
from understudy.errors import InputError
from understudy.model import Hand, Level
from understudy.models import Understudy
from understudy.realization import realize_prepared
from understudy.realizer.body.skeleton import Skeleton, forward

BODY = Skeleton.standing()


def test_a_right_text_has_definitions_and_no_mistakes() -> None:
    found = check_text(gesture(name="first") + gesture(name="second"), BODY)
    assert [definition.name for definition in found.definitions] == ["first", "second"]
    assert (found.mistakes, found.doubts) == ((), ())


def test_a_wrong_text_has_every_mistake_with_its_place_and_no_definition() -> None:
    text = gesture(last="FRAMETYPE stroke_end\n  ARM XC YCC ZNeer\n  WRIST FBUp PalmDown")
    found = check_text(text, BODY)
    lines = text.splitlines()
    places = [(lines[one.line - 1].strip(), lines[one.line - 1][one.column - 1 :]) for one in found.mistakes]
    assert places == [("ARM XC YCC ZNeer", "ZNeer"), ("WRIST FBUp PalmDown", "PalmDown")]
    assert found.definitions == ()


def test_of_very_many_mistakes_the_first_are_told() -> None:
    assert len(check_text("STARTFRAME\n" * 1000, Skeleton.standing()).mistakes) == MOST_MISTAKES


def test_a_pose_out_of_reach_is_doubtful_and_no_mistake() -> None:
    found = check_text(gesture(last="FRAMETYPE stroke_end\n  ARM XEP YUpperEP ZFar"), BODY)
    assert found.mistakes == ()
    assert [doubt.time for doubt in found.doubts] == [0.75]
    assert "from its place" in found.doubts[0].message


def test_one_gesture_of_a_text_is_found_by_name_or_is_the_first() -> None:
    text = gesture(name="first") + gesture(name="second")
    assert one_gesture(text, None).name == "first"
    assert one_gesture(text, "second").name == "second"


@pytest.mark.parametrize(
    ("text", "name", "code", "told"),
    [
        (gesture(), "tryal", "unknown_name", "did you mean 'trial'"),
        ("# nothing\n", None, "gesture_wrong", "defines no gesture"),
        (gesture("ARMS three"), None, "gesture_wrong", "4:6: 'three' is not"),
    ],
)
def test_what_cannot_be_played_is_told(text: str, name: str | None, code: str, told: str) -> None:
    with pytest.raises(InputError, match=told) as caught:
        one_gesture(text, name)
    assert caught.value.code == code


RAISED = gesture(last="FRAMETYPE stroke_end\n  ARM XC YUpperP ZMiddle", name="raised")
SIDES = ("left", "right")


@pytest.mark.parametrize("hand", [Hand.LEFT, Hand.RIGHT])
def test_the_hand_that_is_asked_for_goes_where_the_gesture_says(understudy: Understudy, hand: Hand) -> None:
    """At the stroke's end the wrist is at the height of the shoulders (`YUpperP`), the other hand at rest below.

    At rest it is as high as in the first frame but for 5 cm. Around a gesture alone hands rest before the belly and do
    not hang: the other wrist is 10 cm below (23 cm where the right hand gestures), so that no more can be asked.
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
