"""Lines of gesture files: what each is, where a mistake is told, and that one hides none of the others."""

from pathlib import Path

import pytest

from tests.support.motion.gesture_files import gesture
from understudy.realizer.gestures.language import FRAME, HEADER, parse_gestures, read_gestures

PATH = Path("trial.gesture")


def told(text: str) -> list[tuple[int, int, str]]:
    return [(mistake.line, mistake.column, mistake.message) for mistake in parse_gestures(text, PATH)[1]]


def test_a_file_is_cut_into_gestures_and_frames() -> None:
    file, mistakes = parse_gestures("# both\n" + gesture(name="one") + "\n" + gesture(name="two"), PATH)
    assert mistakes == ()
    assert [tree.header[1].words[0].text for tree in file.gestures] == ["one", "two"]
    frame = file.gestures[0].frames[1]
    assert [statement.keyword.text for statement in frame.statements] == ["FRAMETYPE", "ARM"]
    assert (frame.start.numbers[0].text, frame.start.keyword.line) == ("0.75", 10)


def test_an_arm_s_place_and_offset_and_comment() -> None:
    text = gesture(last="FRAMETYPE stroke_end # here\n\tARM XP YCC ZFar OFFSET .02 -0.1 +1 # there")
    arm = parse_gestures(text, PATH)[0].gestures[0].frames[1].statements[1]
    assert [word.text for word in arm.words] == ["XP", "YCC", "ZFar"]
    assert [(word.text, word.column) for word in arm.numbers] == [(".02", 25), ("-0.1", 29), ("+1", 34)]


@pytest.mark.parametrize("line", [*HEADER.values(), *FRAME.values()])
def test_every_statement_is_written_as_its_example(line: str) -> None:
    """The examples are what mistakes quote; the second way of writing one stands after the comma."""
    for example in line.replace(" behind", "").split(", or with "):
        whole = example if example.split()[0] in {**HEADER, **FRAME} else f"ARM XC YUpperP ZNear {example}"
        written = told(whole)
        assert not any("is written as" in message or "no line begins" in message for *_, message in written)


@pytest.mark.parametrize(
    ("line", "column", "message"),
    [
        ("HNAD form_fist", 3, "did you mean HAND?"),
        ("arm XC YCC ZNear", 3, "did you mean ARM?"),
        ("hello", 3, "lines of a gesture file begin with GESTURECLASS"),
        ("ARM XC YCC", 13, "the line ends too soon; ARM is written as in: ARM XC YUpperP ZNear"),
        ("ARM XC YCC   # ZNear", 13, "the line ends too soon"),
        ("ARM XC YCC ZNear OFFSET 1 2", 30, "the line ends too soon"),
        ("ARM XC 3 ZNear", 10, "found '3'"),
        ("ARM XC YCC ZNear 0.1", 20, "found '0.1'"),
        ("JOINT Hand 1 2 3x", 18, "found '3x'"),
        ("HAND form_fist form_flat", 18, "found 'form_flat'"),
        ("FRAMETYPE", 12, "FRAMETYPE is written as in: FRAMETYPE stroke_end"),
        ("OTHER", 3, "no line begins with 'OTHER'"),
        ("OTHER ADDNOISE", 9, "OTHER sets the other arm's ARM, FINGER, HAND, JOINT, SHOULDER, WRIST"),
        ("HAND 'form_fist'", 8, "found \"'form_fist'\""),
        ("DURATION 3", 3, "DURATION belongs before the first frame"),
    ],
)
def test_a_wrong_line_in_a_frame(line: str, column: int, message: str) -> None:
    ((at_line, at_column, what),) = told(gesture(first=f"FRAMETYPE stroke_start\n  {line}"))
    assert (at_line, at_column) == (7, column)
    assert message in what


@pytest.mark.parametrize(
    ("text", "line", "message"),
    [
        ("DURATION 2", 1, "a gesture begins with GESTURECLASS"),
        (gesture("HAND form_fist"), 4, "HAND belongs in a frame"),
        (gesture("ENDFRAME"), 4, "ENDFRAME without a STARTFRAME before it"),
        (gesture() + "DURATION 3", 13, "DURATION belongs before the first frame"),
        (gesture().replace("ENDFRAME\nSTARTFRAME", "STARTFRAME"), 5, "this frame has no ENDFRAME"),
        (gesture().rstrip()[: -len("ENDFRAME")], 9, "this frame has no ENDFRAME"),
    ],
)
def test_a_line_in_the_wrong_place(text: str, line: int, message: str) -> None:
    ((at_line, _, what),) = told(text)
    assert at_line == line
    assert message in what


def test_a_mistake_hides_no_other() -> None:
    text = gesture("DURATON 1\nARMS", first="FRAMETIPE ready", last="HAND") + "\n" + gesture("CATEGORY 3")
    assert [line for line, *_ in told(text)] == [4, 5, 7, 10, 16]


def test_an_unread_line_counts_as_what_it_was_meant_to_be() -> None:
    """STARTFRAME without its time still begins a frame, and ENDFRAM still ends one."""
    text = gesture().replace("STARTFRAME 0.25", "STARTFRAME").replace("ENDFRAME\nSTARTFRAME", "ENDFRAM\nSTARTFRAME")
    file, mistakes = parse_gestures(text, PATH)
    assert [mistake.line for mistake in mistakes] == [5, 8]
    assert len(file.gestures[0].frames) == 2


def test_windows_lines_and_a_byte_order_mark(tmp_path: Path) -> None:
    path = tmp_path / "windows.gesture"
    path.write_bytes(b"\xef\xbb\xbf" + gesture().replace("\n", "\r\n").encode())
    file, mistakes = read_gestures(path)
    assert mistakes == ()
    assert len(file.gestures) == 1


def test_a_file_that_cannot_be_read(tmp_path: Path) -> None:
    (tmp_path / "latin.gesture").write_bytes(b"GESTURECLASS b\xe9at")
    assert "not UTF-8 text at byte 14" in read_gestures(tmp_path / "latin.gesture")[1][0].message
    assert "cannot be read" in read_gestures(tmp_path / "none.gesture")[1][0].message


def test_a_mistake_points_at_its_word() -> None:
    shown = str(parse_gestures(gesture("DURATON 1"), PATH)[1][0])
    assert shown.splitlines()[1:] == ["    DURATON 1", "    ^"]
