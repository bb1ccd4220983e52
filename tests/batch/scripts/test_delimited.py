"""Sheets as text: separators, quotes, and every wrong cell with its row and column, all at once."""

from pathlib import Path

import pytest

from understudy.batch.model import Script
from understudy.batch.scripts.delimited import read_delimited
from understudy.errors import InputError, UndecodableError
from understudy.model import Interval, Level, Target
from understudy.model.edits import Edits, LineSettings


def read(text: str, **named: str) -> Script:
    return read_delimited(text.encode(), Path("lines.csv"), named)


@pytest.mark.parametrize("separator", [",", ";", "\t", "|"])
def test_any_separator_though_the_words_have_commas(separator: str) -> None:
    rows = [["id", "character", "text"], ["a1", "Ann", '"Well, no, not those, nor these"']]
    script = read("\n".join(separator.join(row) for row in rows))
    (line,) = script.lines
    assert (line.row, line.id, line.character, line.text) == (2, "a1", "Ann", "Well, no, not those, nor these")


def test_all_that_a_sheet_can_say_of_a_line() -> None:
    script = read(
        "id,text,file,direction,scene,take,start,end,listener,agitation,seed,target\n"
        'a1,"Two\nrows",v/a.wav,whispers,4,2.0,1:02.5,63,"Ben; Cat",HIGH,7,"door=1,1.4,2; Ben=0,1.5,1"\n'
    )
    (line,) = script.lines
    assert script.problems == ()
    assert (line.text, line.recording, line.comment, line.scene) == ("Two rows", "v/a.wav", "whispers", "4")
    assert (line.take, line.seed, line.agitation, line.listeners) == (2, 7, Level.HIGH, ("Ben", "Cat"))
    assert line.interval == Interval(62.5, 63)
    assert line.targets == (Target("door", (1.0, 1.4, 2.0)), Target("Ben", (0.0, 1.5, 1.0)))


def test_director_notes_in_a_cell_or_a_file_beside_the_sheet(tmp_path: Path) -> None:
    notes = '{"moments": [{"first": 0, "last": 1, "gesture": ["negation"]}]}'
    (tmp_path / "b.json").write_text(notes)
    doubled = notes.replace('"', '""')
    sheet = f'id,text,direction\na,not those,"{doubled}"\nb,not those,b.json\nc,not those,softly\n'
    script = read_delimited(sheet.encode(), tmp_path / "lines.csv", {})
    first, second, third = script.lines
    assert first.direction is not None
    assert first.direction == second.direction
    assert (third.direction, third.comment) == (None, "softly")


def test_edits_in_a_cell_or_a_file_beside_the_sheet(tmp_path: Path) -> None:
    edits = '{"line": {"seed": 4}}'
    (tmp_path / "b.edits.json").write_text(edits)
    doubled = edits.replace('"', '""')
    sheet = f'id,text,edits\na,not those,"{doubled}"\nb,not those,b.edits.json\nc,not those,\nd,words,gone.json\n'
    script = read_delimited(sheet.encode(), tmp_path / "lines.csv", {})
    assert [line.edits for line in script.lines] == [Edits(LineSettings(seed=4)), Edits(LineSettings(seed=4)), None]
    assert [(problem.column, problem.code) for problem in script.problems] == [("C (edits)", "file_unreadable")]


def test_every_problem_is_told_with_its_row_and_column() -> None:
    script = read(
        "id,text,seed,direction,start,target\n"
        "a,fine,,,\n"
        "b,,x,,,door\n"
        ",words,,,\n"
        'A,words,,"{""moments"": 3}",\n'
        "A,words,,,\n"
        "e,words,,gone.json,12\n"
        "f,words,,,,,spare\n"
    )
    assert [line.id for line in script.lines] == ["a"]
    assert [(problem.row, problem.column, problem.code) for problem in script.problems] == [
        (3, "C (seed)", "value_wrong"),
        (3, "F (target)", "target_wrong"),
        (3, "B (text)", "text_empty"),
        (4, "A (id)", "id_missing"),
        (5, "D (direction)", "direction_wrong"),
        (6, "A (id)", "id_repeated"),
        (7, "D (direction)", "file_unreadable"),
        (7, "E (start)", "value_wrong"),
        (8, "", "row_too_long"),
    ]


def test_without_ids_lines_go_by_their_recording_or_row() -> None:
    assert [line.id for line in read("file,text\nv\\x.wav,yes\n").lines] == ["x"]
    assert [line.id for line in read("text,who\nyes,Ann\n\nno,Ben\n").lines] == ["row00002", "row00004"]


def test_a_broken_quote_is_told_with_its_line() -> None:
    with pytest.raises(UndecodableError, match="line 3") as raised:
        read('id,text\na,"yes"\nb,"no\nc,perhaps\n')
    assert raised.value.code == "sheet_undecodable"


def test_an_empty_sheet_is_refused() -> None:
    with pytest.raises(InputError) as raised:
        read("\n\n")
    assert raised.value.code == "script_empty"
