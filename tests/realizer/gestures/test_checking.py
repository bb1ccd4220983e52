"""Gestures that are written well and make no sense (Gesture Engine §4.3)."""

from pathlib import Path

import pytest

from tests.support.motion.gesture_files import FIRST, LAST, gesture, mistakes_in, read_one
from understudy.errors import AuthoringError
from understudy.realizer.gestures.library import read_definitions


def frames(*types: str) -> str:
    """A gesture of frames of these types, the first with a place."""
    text = "GESTURECLASS beat\nGESTUREINSTANCE trial\nDURATION 1\n"
    for number, type_ in enumerate(types):
        place = "ARM XC YCC ZNear\n" if number == 0 else ""
        text += f"STARTFRAME {number / 20}\nFRAMETYPE {type_}\n{place}ENDFRAME\n"
    return text


@pytest.mark.parametrize(
    "types",
    [
        "stroke_start stroke_end",
        "ready stroke",
        "stroke stroke",
        "start preparation preparation ready stroke_start stroke stroke stroke_end hold hold relax retraction end",
    ],
)
def test_phases_in_their_order(tmp_path: Path, types: str) -> None:
    assert len(read_one(tmp_path, frames(*types.split())).frames) == len(types.split())


@pytest.mark.parametrize(
    ("types", "told"),
    [
        ("stroke_end stroke_start stroke", "stroke_start cannot follow stroke_end"),
        ("stroke_start hold stroke_end", "stroke_end cannot follow hold"),
        ("stroke_start stroke_start stroke_end", "a gesture has one stroke_start"),
        ("start end", "this gesture has no stroke"),
        ("stroke_start hold", "this gesture has no stroke"),
        ("stroke", "the stroke is the first frame and takes no time"),
        ("stroke_end hold", "the stroke is the first frame and takes no time"),
    ],
)
def test_phases_that_make_no_gesture(tmp_path: Path, types: str, told: str) -> None:
    (mistake,) = mistakes_in(tmp_path, frames(*types.split()))
    assert told in mistake.message


def test_a_gesture_without_frames(tmp_path: Path) -> None:
    (mistake,) = mistakes_in(tmp_path, frames())
    assert "this gesture has no frames" in mistake.message


@pytest.mark.parametrize(
    ("first", "last", "places"),
    [("0.5", "0.5", [(9, 12)]), ("0.5", "0.4", [(9, 12)]), ("-0.1", "1.01", [(5, 12), (9, 12)])],
)
def test_times_rise_within_the_gesture(tmp_path: Path, first: str, last: str, places: list[tuple[int, int]]) -> None:
    found = mistakes_in(tmp_path, gesture().replace("0.25", first).replace("0.75", last))
    assert [(one.line, one.column) for one in found] == places


def test_times_from_beginning_to_end(tmp_path: Path) -> None:
    found = read_one(tmp_path, gesture().replace("0.25", "0").replace("0.75", "1"))
    assert [frame.time for frame in found.frames] == [0, 1]


def test_the_first_frame_puts_the_arm_somewhere(tmp_path: Path) -> None:
    (mistake,) = mistakes_in(tmp_path, gesture(first="FRAMETYPE stroke_start"))
    assert (mistake.line, mistake.message[:41]) == (5, "the first frame must say where the arm is")
    fixed = "FRAMETYPE stroke_start\nJOINT UpperArm 0 0 -60\nJOINT LowerArm 0 -90 0"
    assert read_one(tmp_path, gesture(first=fixed)).frames[0].leading.place is None


def test_a_frame_has_a_type(tmp_path: Path) -> None:
    (mistake,) = mistakes_in(tmp_path, gesture(last="ARM XC YCC ZNear"))
    assert (mistake.line, mistake.message) == (9, "this frame has no FRAMETYPE")


@pytest.mark.parametrize(
    ("line", "what"),
    [
        ("ARM XP YCC ZFar", "ARM"),
        ("FRAMETYPE stroke_end", "FRAMETYPE"),
        ("FINGER index straight\nFINGER index bend_hooked", "FINGER index"),
        ("JOINT Hand 0 0 0\nJOINT Hand 0 0 1", "JOINT Hand"),
        ("ADDNOISE\nADDNOISE", "ADDNOISE"),
        ("OTHER HAND form_fist\nHAND form_fist\nOTHER HAND form_flat", "OTHER HAND"),
    ],
)
def test_a_frame_says_a_thing_once(tmp_path: Path, line: str, what: str) -> None:
    (mistake,) = mistakes_in(tmp_path, gesture("ARMS both", last=f"{LAST}\n{line}"))
    assert f"duplicate {what}" in mistake.message


@pytest.mark.parametrize("header", ["", "ARMS left"])
def test_other_needs_both_arms(tmp_path: Path, header: str) -> None:
    (mistake,) = mistakes_in(tmp_path, gesture(header, first=f"{FIRST}\n  OTHER HAND form_fist"))
    assert (mistake.line, mistake.column) == (8, 9)
    assert "write ARMS both in its header" in mistake.message


def test_names_are_said_once_among_all_files(tmp_path: Path) -> None:
    paths = [tmp_path / name for name in ("a.gesture", "b.gesture")]
    for path in paths:
        path.write_text(gesture(name="wave"), encoding="utf-8")
    with pytest.raises(AuthoringError) as caught:
        read_definitions(paths)
    (mistake,) = caught.value.mistakes
    assert (mistake.path, mistake.line, mistake.column) == (paths[1], 2, 17)
    assert f"a gesture called wave is also at {paths[0]}:2" in mistake.message
