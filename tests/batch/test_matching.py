"""Lines are matched with recordings; unmatched ones and duplicates are reported."""

from pathlib import Path

import pytest

from understudy.batch.matching import (
    JoinedLines,
    RecordingFile,
    RecordingPattern,
    TakeChoice,
    find_recordings,
    join_recordings,
)
from understudy.batch.model import ScriptLine
from understudy.errors import InputError


def join(
    folder: Path, lines: list[ScriptLine], names: list[str], pattern: str = "", choice: TakeChoice = TakeChoice.LAST
) -> JoinedLines:
    for name in names:
        path = folder / "audio" / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.touch()
    files = find_recordings(folder / "audio", without=folder / "audio" / "out")
    return join_recordings(lines, files, RecordingPattern.of(pattern) if pattern else None, choice)


def line(name: str, recording: str = "", take: int | None = None, character: str = "") -> ScriptLine:
    return ScriptLine(row=2, id=name, text="no", recording=recording, take=take, character=character)


def found(joined: JoinedLines) -> dict[str, str]:
    return {take.id: take.recording.path.name for take in joined.takes}


def test_by_id_whatever_the_capitals_and_folders(tmp_path: Path) -> None:
    joined = join(tmp_path, [line("A1"), line("a2")], ["a1.wav", "deep/er/A2.FLAC", "notes.txt", ".a3.wav"])
    assert found(joined) == {"A1": "a1.wav", "a2": "A2.FLAC"}
    assert joined.unused == ()


def test_by_the_file_that_the_line_names_however_it_was_delivered(tmp_path: Path) -> None:
    lines = [line("x", "v\\one.wav"), line("y", "v/two.mp3"), line("z", "three"), line("one", "four.wav")]
    joined = join(tmp_path, lines, ["v/one.wav", "one.wav", "w/two.ogg", "three.wav"])
    assert [str(take.recording.path.relative_to(tmp_path)) for take in joined.takes] == [
        "audio/v/one.wav",
        "audio/w/two.ogg",
        "audio/three.wav",
    ]
    assert [missing.line.id for missing in joined.missing] == ["one"]
    assert [path.parent.name for path in joined.unused] == ["audio"]


def test_by_a_pattern_in_which_zeros_before_a_number_do_not_count(tmp_path: Path) -> None:
    lines = [line("7", character="Ann"), line("7b", character="Ben")]
    names = ["ANN/line_007_t1.wav", "ANN/line_007_t2.wav", "Ben/line_7b_t1.wav", "Ben/line_7c_t1.wav"]
    joined = join(tmp_path, lines, names, "{character}/line_{id}_t{take}.wav")
    assert found(joined) == {"7": "line_007_t2.wav", "7b": "line_7b_t1.wav"}
    assert [path.name for path in joined.unused] == ["line_7c_t1.wav"]


@pytest.mark.parametrize("pattern", ["", "{id}.wav"])
def test_a_name_of_more_digits_than_python_reads_as_a_number_has_no_recording(pattern: str, tmp_path: Path) -> None:
    joined = join(tmp_path, [line("9" * 5000), line("0")], ["00.wav"], pattern)
    assert found(joined) == ({"0": "00.wav"} if pattern else {})
    assert joined.missing[0].line.id == "9" * 5000


@pytest.mark.parametrize(
    ("choice", "expected"),
    [
        (TakeChoice.LAST, {"a": "a (10).wav", "b": "b.wav"}),
        (TakeChoice.FIRST, {"a": "a_t2.wav", "b": "b.wav"}),
        (TakeChoice.ALL, {"a_t2": "a_t2.wav", "a_t3": "a take 3.wav", "a_t10": "a (10).wav", "b": "b.wav"}),
    ],
)
def test_takes(choice: TakeChoice, expected: dict[str, str], tmp_path: Path) -> None:
    names = ["a_t2.wav", "a take 3.wav", "a (10).wav", "b.wav"]
    assert found(join(tmp_path, [line("a"), line("b")], names, choice=choice)) == expected


def test_a_line_may_choose_its_take(tmp_path: Path) -> None:
    joined = join(tmp_path, [line("a", take=2), line("b", take=4)], ["a_t2.wav", "a_t3.wav", "b_t1.wav", "b_t2.wav"])
    assert found(joined) == {"a": "a_t2.wav"}
    assert [missing.line.id for missing in joined.missing] == ["b"]


def test_near_misses_are_named_and_the_next_number_is_none(tmp_path: Path) -> None:
    lines = [line("scene2_14"), line("scene2_15"), line("gate_guard_3")]
    joined = join(tmp_path, lines, ["scene2_014.wav", "scene2_16.wav", "gate_gaurd_03.wav"])
    assert [missing.near for missing in joined.missing] == ["scene2_014", None, "gate_gaurd_03"]


def test_what_is_there_twice_is_told(tmp_path: Path) -> None:
    joined = join(tmp_path, [line("a"), line("b", "a.wav")], ["a.wav", "x/a.flac"])
    assert [(rival.id, len(paths)) for rival, paths in joined.rivals] == [("a", 2)]
    assert [[each.id for each in lines] for _path, lines in joined.shared] == [["a", "b"]]


@pytest.mark.parametrize("pattern", ["{name}.wav", "{id.wav", "take{take}.wav", "id.wav"])
def test_a_pattern_that_finds_no_line_is_refused(pattern: str) -> None:
    with pytest.raises(InputError) as raised:
        RecordingPattern.of(pattern)
    assert raised.value.code == "pattern_wrong"


def test_ten_thousand_lines_are_joined_at_once(tmp_path: Path) -> None:
    lines = [line(f"scene{number // 100}_{number % 100:02}") for number in range(10_000)]
    files = [RecordingFile.of(tmp_path / f"{each.id}.wav", tmp_path) for each in lines[::2]]
    joined = join_recordings(lines, files, RecordingPattern.of("{id}.wav"))
    assert (len(joined.takes), len(joined.missing)) == (5_000, 5_000)
