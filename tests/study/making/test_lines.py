"""Lines from folders and scripts."""

from pathlib import Path

import pytest

from understudy.errors import InputError
from understudy.files import resource_folder
from understudy.options import Options
from understudy.study.making.lines import StudySource, read_lines

AUDIO = (resource_folder("examples") / "example.flac").read_bytes()


def _folder(path: Path, *names: str) -> Path:
    for name in names:
        (path / f"{name}.flac").write_bytes(AUDIO)
        (path / f"{name}.txt").write_text(f"Words of {name}.\n")
    return path


def test_a_folder_has_a_line_for_each_recording(tmp_path: Path) -> None:
    lines = read_lines(StudySource(_folder(tmp_path, "b", "a"), None, tmp_path / "out"), Options(seed=3))
    assert [(each.id, each.line.text, each.options.seed) for each in lines] == [
        ("a", "Words of a.\n", 3),
        ("b", "Words of b.\n", 3),
    ]
    assert lines[0].line.audio == AUDIO


def test_a_recording_without_words_is_told(tmp_path: Path) -> None:
    _folder(tmp_path, "a", "b")
    (tmp_path / "b.txt").unlink()
    with pytest.raises(InputError, match=r"no words for b\.flac") as raised:
        read_lines(StudySource(tmp_path, None, tmp_path / "out"), Options())
    assert raised.value.code == "study_lines"


def test_a_folder_without_recordings_is_told(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="no recordings in it"):
        read_lines(StudySource(tmp_path, None, tmp_path / "out"), Options())


def test_a_script_finds_its_recordings_beside_it(tmp_path: Path) -> None:
    script = _folder(tmp_path, "a", "b") / "lines.csv"
    script.write_text("audio,text,seed\nb.flac,Said second.,\na.flac,Said first.,5\n")
    lines = read_lines(StudySource(script, None, tmp_path / "out"), Options(seed=1))
    assert [(each.line.text, each.options.seed) for each in lines] == [("Said second.", 1), ("Said first.", 5)]


def test_every_line_of_a_script_must_be_there(tmp_path: Path) -> None:
    script = _folder(tmp_path, "a") / "lines.csv"
    script.write_text("id,text\na,Here.\nz,Not here.\n")
    with pytest.raises(InputError, match="row 3: no recording") as raised:
        read_lines(StudySource(script, None, tmp_path / "out"), Options())
    assert raised.value.code == "study_lines"
