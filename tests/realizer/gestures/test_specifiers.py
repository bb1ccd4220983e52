"""What the lines of a frame say of an arm, and what they cannot say."""

from itertools import product
from pathlib import Path

import pytest

from tests.support.motion.gesture_files import FIRST, LAST, gesture, mistakes_in, read_one
from understudy.realizer.gestures.gesture import (
    ArmKey,
    Bend,
    Depth,
    Finger,
    HandDirection,
    HandForm,
    HandShape,
    HeightSector,
    KeyCurve,
    SectorPlace,
    Sideways,
    Thumb,
    Wrist,
)
from understudy.realizer.gestures.specifiers import THUMB_IN_FORM, orthogonal


def key(folder: Path, *lines: str) -> ArmKey:
    return read_one(folder, gesture(last="\n".join(["FRAMETYPE stroke_end", *lines]))).frames[1].leading


def message(folder: Path, line: str) -> tuple[int, str]:
    """Column and text of the first mistake of a frame with this line."""
    (mistake, *_) = mistakes_in(folder, gesture(last=f"FRAMETYPE stroke_end\n{line}"))
    return mistake.column, mistake.message


def test_every_channel_of_a_frame(tmp_path: Path) -> None:
    said = key(
        tmp_path,
        "ARM XOppC YUpperEP ZFar OFFSET 0.02 -0.05 0",
        "HAND symbol_2apart_across",
        "FINGER ring bend_closed",
        "FINGER index straight",
        "WRIST FBUpAway PalmInwards",
        "SHOULDER -0.5",
        "JOINT LowerArm 0 -80 10",
        "JOINT IndexDistal 0 0 90",
    )
    assert said == ArmKey(
        place=SectorPlace(Sideways.OPP_C, HeightSector.UPPER_EP, Depth.FAR, (0.02, -0.05, 0.0)),
        hand=HandShape(HandForm.TWO_APART, Thumb.ACROSS),
        fingers=((Finger.RING, Bend.CLOSED), (Finger.INDEX, Bend.STRAIGHT)),
        wrist=Wrist(frozenset({HandDirection.UP, HandDirection.AWAY}), frozenset({HandDirection.INWARDS})),
        shoulder=-0.5,
        joints=(("LowerArm", (0.0, -80.0, 10.0)), ("IndexDistal", (0.0, 0.0, 90.0))),
    )


def test_a_frame_that_says_nothing_of_the_arm_leaves_all_open(tmp_path: Path) -> None:
    assert key(tmp_path) == ArmKey()


@pytest.mark.parametrize(("form", "thumb"), [*product(HandForm, [Thumb.OPEN, Thumb.OUT, Thumb.ACROSS])])
def test_a_thumb_goes_with_the_forms_that_it_does_not_make(tmp_path: Path, form: HandForm, thumb: Thumb) -> None:
    line = f"HAND {form}_{thumb}"
    if form in THUMB_IN_FORM:
        assert message(tmp_path, line) == (
            6,
            f"the thumb takes part in {form} and cannot be {thumb} as well; write {form}",
        )
    else:
        assert key(tmp_path, line).hand == HandShape(form, thumb)


def test_there_are_twelve_basic_forms_and_the_hand_at_ease(tmp_path: Path) -> None:
    assert len(HandForm) == 12 + 1
    for form in HandForm:
        assert key(tmp_path, f"HAND {form}").hand == HandShape(form)


def test_the_wrist_as_the_forearm_has_it(tmp_path: Path) -> None:
    assert key(tmp_path, "WRIST FBDefault PalmDefault").wrist == Wrist()


@pytest.mark.parametrize("base", HandDirection)
def test_the_palm_is_at_a_right_angle_to_the_fingers(tmp_path: Path, base: HandDirection) -> None:
    """Of the six directions four are: not the finger base's own, and not its opposite (Gesture Engine §4.3)."""
    axes = [{"Up", "Down"}, {"Inwards", "Outwards"}, {"Away", "Towards"}]
    for palm in HandDirection:
        text = f"WRIST FB{base} Palm{palm}"
        if any({base, palm} <= axis for axis in axes):
            column, told = message(tmp_path, text)
            assert column == len(f"WRIST FB{base} ") + 1
            fitting = [f"Palm{one}" for one in HandDirection if orthogonal({base}, {one})]
            assert f"right would be {', '.join(fitting)}" in told
            assert len(fitting) == 4
        else:
            assert key(tmp_path, text).wrist == Wrist(frozenset({base}), frozenset({palm}))


def test_sums_of_directions_are_orthogonal_when_their_product_is_zero() -> None:
    up, down, away = HandDirection.UP, HandDirection.DOWN, HandDirection.AWAY
    assert orthogonal({up, away}, {down, away})
    assert orthogonal({up, away}, {HandDirection.INWARDS})
    assert not orthogonal({up, away}, {away})
    assert not orthogonal({up, away, HandDirection.INWARDS}, {down, away, HandDirection.INWARDS})


@pytest.mark.parametrize(
    ("line", "column", "told"),
    [
        ("ARM XX YCC ZNear", 5, "'XX' is not a sector across the body: one of XEP, XP, XC, XCC, XOppC, XOppP, XOppEP"),
        ("ARM YCC XC ZNear", 5, "'YCC' is not a sector across the body; did you mean XCC?"),
        ("ARM XC YCC ZNeer", 12, "'ZNeer' is not a distance from the body; did you mean ZNear?"),
        ("ARM XC YCC ZNear OFFSET 0 0.31 0", 27, "0.31 is outside -0.3 … 0.3 m"),
        ("HAND form_fits", 6, "did you mean form_fist?"),
        ("HAND symbol_1_up", 6, "'symbol_1_up' is not a form of the hand"),
        ("FINGER pinky straight", 8, "'pinky' is not a finger: one of thumb, index, middle, ring, little"),
        ("FINGER index bend", 14, "'bend' is not a finger's bend"),
        ("WRIST FBUpDown PalmAway", 7, "Up and Down are opposite"),
        ("WRIST FBUpUp PalmAway", 7, "a direction is repeated"),
        ("WRIST FB PalmAway", 7, "'FB' is not FB and directions"),
        ("WRIST PalmAway FBUp", 7, "'PalmAway' is not FB and directions"),
        ("WRIST FBUp PalmForwards", 12, "'PalmForwards' is not Palm and directions, as PalmUp or PalmUpAway"),
        ("SHOULDER 1.5", 10, "1.5 is outside -1 … 1"),
        ("JOINT Elbow 0 0 0", 7, "'Elbow' is not a joint of the arm"),
        ("JOINT Hand 0 0 181", 16, "181 is outside -180 … 180°"),
    ],
)
def test_a_word_that_is_none_of_the_language(tmp_path: Path, line: str, column: int, told: str) -> None:
    found = message(tmp_path, line)
    assert found[0] == column
    assert told in found[1]


def test_the_other_arm_mirrors_what_is_not_said_of_it(tmp_path: Path) -> None:
    """Fingers are part of the hand: with a hand of its own the other arm does not take the leading one's fingers."""
    own = f"{FIRST}\nHAND symbol_1\nFINGER index bend_curved\nWRIST FBUp PalmAway"
    text = gesture("ARMS both", first=f"{own}\nOTHER HAND form_fist\nOTHER SHOULDER 1")
    first, last = read_one(tmp_path, text).frames
    assert first.other == ArmKey(
        place=first.leading.place, hand=HandShape(HandForm.FIST), wrist=first.leading.wrist, shoulder=1.0
    )
    assert last.other is None


def test_a_frame_sets_the_curve_at_its_pose(tmp_path: Path) -> None:
    lines = f"{LAST}\n  TENSION 0.5\n  BIAS -1"
    first, last = read_one(tmp_path, gesture(last=lines)).frames
    assert first.curve == KeyCurve()
    assert last.curve == KeyCurve(tension=0.5, bias=-1.0)


@pytest.mark.parametrize(
    ("line", "column", "told"),
    [
        ("TENSION 1.5", 11, "1.5 is outside -1 … 1"),
        ("CONTINUITY -2", 14, "-2 is outside -1 … 1"),
        ("BIAS much", 8, "found 'much'; BIAS is written as in: BIAS 0.3"),
        ("TENSON 0.5", 3, "no line begins with 'TENSON'; did you mean TENSION?"),
        ("OTHER BIAS 0.5", 9, "OTHER sets the other arm's"),
        ("BIAS 0\n  BIAS 1", 3, "duplicate BIAS"),
    ],
)
def test_a_curve_that_is_none_of_the_language(tmp_path: Path, line: str, column: int, told: str) -> None:
    (mistake,) = mistakes_in(tmp_path, gesture(last=f"{LAST}\n  {line}"))
    assert (mistake.line, mistake.column) == (12 + line.count("\n"), column)
    assert mistake.message.startswith(told)
