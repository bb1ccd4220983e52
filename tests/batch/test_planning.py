"""Files of edits beside recordings: to which line they belong, and mistakes in them."""

import json
from pathlib import Path

import pytest

from understudy.batch.model import Recording, ScriptLine, Take
from understudy.batch.planning import edits_of_takes
from understudy.model.edits import Edits, LineSettings

SEED_4 = Edits(LineSettings(seed=4))
OWN = Edits(LineSettings(seed=5))


def _take(folder: Path, *, edits: Edits | None = None) -> Take:
    line = ScriptLine(2, "one", "No.", edits=edits)
    return Take("one_t2", line, Recording(folder / "scene one.wav"), 2)


@pytest.mark.parametrize("name", ["one_t2", "one", "scene one"])
def test_a_file_goes_by_the_take_the_line_or_the_recording(tmp_path: Path, name: str) -> None:
    (tmp_path / f"{name}.edits.json").write_text(json.dumps({"line": {"seed": 4}}))
    assert edits_of_takes([_take(tmp_path)]) == ({"one_t2": SEED_4}, ())


def test_what_the_script_says_goes_before_a_file(tmp_path: Path) -> None:
    (tmp_path / "one.edits.json").write_text("{")
    assert edits_of_takes([_take(tmp_path, edits=OWN)]) == ({"one_t2": OWN}, ())


def test_lines_without_edits_have_none(tmp_path: Path) -> None:
    assert edits_of_takes([_take(tmp_path)]) == ({}, ())


def test_a_wrong_file_is_a_problem_of_its_line_alone(tmp_path: Path) -> None:
    (tmp_path / "one.edits.json").write_text('{"line": {"seeds": 4}}')
    found, [problem] = edits_of_takes([_take(tmp_path)])
    assert found == {}
    assert (problem.row, problem.id, problem.code) == (2, "one_t2", "edits_wrong")
    assert "one.edits.json" in problem.message
