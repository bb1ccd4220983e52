"""A gesture's text: its mistakes with their places, or its definitions and doubts about them."""

import pytest

from tests.support.motion.gesture_files import gesture
from understudy.authoring.gesture_texts import check_text, one_gesture
from understudy.errors import InputError
from understudy.realizer.body.skeleton import Skeleton

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
