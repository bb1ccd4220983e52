"""Scripts as studios send them are understood, and it is said how."""

from pathlib import Path

import pytest

from tests.support.words.voice_scripts import SCREENPLAY, SHEET, Rows, acts, workbook
from understudy.batch.model import Script
from understudy.batch.scripts.columns import ColumnNames, find_columns
from understudy.batch.scripts.reading import read_script
from understudy.errors import InputError

NAMES = ColumnNames.load()


def read(folder: Path, name: str, content: bytes, *sheets: str, **named: str) -> Script:
    (folder / name).write_bytes(content)
    return read_script(folder / name, named, sheets)


@pytest.mark.parametrize(
    ("header", "fields"),
    [
        (["ID", "Character", "Line"], {"id": 0, "character": 1, "text": 2}),
        (["Line", "Character", "Dialogue"], {"id": 0, "character": 1, "text": 2}),
        (["Line #", "Character", "Line"], {"id": 0, "character": 1, "text": 2}),
        (["Line No.", "Script"], {"id": 0, "text": 1}),
        (["Character", "Line"], {"character": 0, "text": 1}),
        (["#", "Lines"], {"id": 0, "text": 1}),
        (["ID", "Line", "Dialogue"], {"id": 0, "text": 2}),
    ],
)
def test_a_line_is_the_words_or_their_number(header: list[str], fields: dict[str, int]) -> None:
    assert dict(find_columns(header, NAMES, {}, file="lines.csv").places) == fields


@pytest.mark.parametrize(("heading", "place"), [("Line", 1), ("line", 1), ("LINE #", 0), ("line no", 0)])
def test_a_heading_that_is_named_exactly_goes_before_others(heading: str, place: int) -> None:
    assert find_columns(["Line #", "Line"], NAMES, {"text": heading}, file="lines.csv").places["text"] == place


def test_a_sheet_from_windows_with_a_title(tmp_path: Path) -> None:
    script = read(tmp_path, "lines.csv", SHEET)
    told = [(line.row, line.id, line.character, line.text, line.comment, line.take) for line in script.lines]
    assert told == [
        (5, "VO_001", "Zoë", "You can't cross here. Not tonight.", "calm", 2),
        (6, "VO_002", "SÄNGERIN", "And who will stop me – you?", "laughs", None),
        (7, "VO_003", "Zoë", "If I have to.", "", 1),
        (9, "VO_004", "Jörg Müller", "Let her pass, Zoë.", "tired", None),
    ]
    assert script.problems == ()
    assert script.columns[:3] == (("id", "A (Line #)"), ("character", "B (Character)"), ("text", "C (Line)"))
    assert read(tmp_path, "lines.csv", SHEET, text="Line").lines == script.lines


def test_a_title_is_not_taken_for_the_headings_that_are_missing(tmp_path: Path) -> None:
    sheet = "Projekt: Brücke,,\n,,\nNummer,Wer spricht,Satz\n1,Zoë,Nein.\n"
    with pytest.raises(InputError, match="'Nummer', 'Wer spricht', 'Satz'"):
        read(tmp_path, "lines.csv", sheet.encode())


def test_all_worksheets_that_look_alike_are_read(tmp_path: Path) -> None:
    script = read(tmp_path, "lines.xlsx", acts())
    assert [(line.id, line.sheet, line.scene, line.row) for line in script.lines] == [
        ("A1_01", "Act 1", "Act 1", 2),
        ("A1_02", "Act 1", "Act 1", 3),
        ("A2_01", "Act 2", "Act 2", 2),
    ]
    assert [str(problem) for problem in script.problems] == [
        "sheet 'Act 2', row 4, column C (Line): no words; write what is spoken",
        "sheet 'Act 2', row 3: 'A1_02' is sheet 'Act 1', row 3's already; give each line its own id",
    ]
    (remark,) = script.remarks
    assert "read worksheets 'Act 1', 'Act 2'; left out 'Info', 'Budget'" in remark


def test_worksheets_are_chosen(tmp_path: Path) -> None:
    script = read(tmp_path, "lines.xlsx", acts(), "act 2")
    assert [line.id for line in script.lines] == ["A2_01", "A1_02"]
    assert "left out 'Info', 'Act 1', 'Budget'" in script.remarks[0]
    with pytest.raises(InputError, match="did you mean 'Act 2'") as raised:
        read(tmp_path, "lines.xlsx", acts(), "Akt 2")
    assert raised.value.code == "sheet_missing"
    with pytest.raises(InputError, match="no worksheets"):
        read(tmp_path, "lines.csv", SHEET, "Act 1")


def test_lines_without_ids_are_named_after_their_sheets(tmp_path: Path) -> None:
    pages: dict[str, Rows] = {title: [["Character", "Line"], ["Ann", f"{title}."]] for title in ("One", "Two")}
    script = read(tmp_path, "lines.xlsx", workbook(pages))
    assert [line.id for line in script.lines] == ["One_row00002", "Two_row00002"]


def test_a_screenplay_has_lines_and_its_names_their_letters(tmp_path: Path) -> None:
    script = read(tmp_path, "watch.fountain", SCREENPLAY.encode())
    assert script.unit == "line"
    assert [(line.row, line.character, line.text) for line in script.lines] == [
        (5, "ZOË", "You can't cross here."),
        (9, "SÄNGERIN", "Then sing with me."),
        (14, "JÖRG MÜLLER", "There was no bridge."),
    ]
