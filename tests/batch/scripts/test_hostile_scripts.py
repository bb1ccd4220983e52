"""Scripts that are small and claim to be large, or are made to break their reader: refused in a line, at once."""

import io
import os
import time
import zipfile
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path

import pytest
from openpyxl import Workbook

from understudy.batch.casting import read_cast
from understudy.batch.matching import find_recordings
from understudy.batch.scripts import workbooks
from understudy.batch.scripts.reading import read_script
from understudy.batch.scripts.sheets import LONGEST_CELL, MOST_COLUMNS, MOST_ROWS
from understudy.errors import InputError, TooLargeError

SHEET = "xl/worksheets/sheet1.xml"
NAMESPACE = 'xmlns="http://schemas.openxmlformats.org/spreadsheetml/2006/main"'


def workbook(sheet: str | None = None, **parts: str) -> bytes:
    """A workbook of two rows, with the XML of its sheet and other parts replaced."""
    book = Workbook()
    page = book.active
    assert page is not None
    page.append(["id", "text"])
    page.append(["a", "No, not those."])
    whole = io.BytesIO()
    book.save(whole)
    told = io.BytesIO()
    with zipfile.ZipFile(whole) as before, zipfile.ZipFile(told, "w", zipfile.ZIP_DEFLATED) as after:
        for name in before.namelist():
            content = before.read(name)
            after.writestr(name, sheet if name == SHEET and sheet is not None else parts.get(name, content))
    return told.getvalue()


def rows(*inside: str, claims: str = "A1:B2") -> str:
    return f'<worksheet {NAMESPACE}><dimension ref="{claims}"/><sheetData>{"".join(inside)}</sheetData></worksheet>'


def cell(place: str, text: str) -> str:
    return f'<c r="{place}" t="inlineStr"><is><t>{text}</t></is></c>'


HEADINGS = f'<row r="1">{cell("A1", "id")}{cell("B1", "text")}</row>'


def read(folder: Path, content: bytes, name: str = "lines.xlsx") -> int:
    """The number of lines in a script."""
    (folder / name).write_bytes(content)
    return len(read_script(folder / name, {}).lines)


def refusal(folder: Path, content: bytes, name: str = "lines.xlsx") -> InputError:
    with pytest.raises(InputError) as raised:
        read(folder, content, name)
    assert "\n" not in raised.value.message
    return raised.value


def test_a_sheet_is_as_large_as_what_is_in_it(tmp_path: Path) -> None:
    line = f'<row r="2">{cell("A2", "a")}{cell("B2", "No.")}</row>'
    assert read(tmp_path, workbook(rows(HEADINGS, line, claims="A1:XFD1048576"))) == 1


def test_notes_beside_the_headings_are_no_cells_too_many(tmp_path: Path) -> None:
    line = f'<row r="2">{cell("A2", "a")}{cell("B2", "No.")}{cell("D2", "ask Jo")}</row>'
    assert read(tmp_path, workbook(rows(HEADINGS, line))) == 1


@pytest.mark.parametrize(
    "make",
    [
        lambda: workbook(rows(HEADINGS, f'<row r="2">{cell("XFD2", "far")}</row>', claims="A1:XFD2")),
        lambda: workbook(rows(HEADINGS, f'<row r="2">{cell("A2", "a")}{cell("B2", "x" * (LONGEST_CELL + 1))}</row>')),
        lambda: workbook(rows(HEADINGS, f'<row r="2">{cell("A2", "a")}{cell("B2", "x" * (100 << 20))}</row>')),
    ],
    ids=["columns", "a long cell", "a cell of 100 MB"],
)
def test_what_is_too_large_is_told_in_a_line(tmp_path: Path, make: Callable[[], bytes]) -> None:
    error = refusal(tmp_path, make())
    assert isinstance(error, TooLargeError)
    assert error.code == "sheet_too_large"


def test_empty_rows_and_cells_and_sheets_are_counted_too(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A few kilobytes may have millions of them."""
    monkeypatch.setattr(workbooks, "MOST_READ_ROWS", 50)
    monkeypatch.setattr(workbooks, "MOST_READ_CELLS", 500)
    for inside, told in (("<row/>" * 51, "50 rows"), (f"<row>{'<c/>' * 251}</row>" * 2, "500 cells, empty ones too")):
        error = refusal(tmp_path, workbook(rows(HEADINGS, inside)))
        assert (error.code, told in error.message) == ("sheet_too_large", True)
    book = Workbook()
    for _ in range(workbooks.MOST_SHEETS):
        book.create_sheet()
    told_book = io.BytesIO()
    book.save(told_book)
    assert "201 worksheets" in refusal(tmp_path, told_book.getvalue()).message


def test_a_heading_of_a_million_cells_is_refused_at_once(tmp_path: Path) -> None:
    began_s = time.process_time()
    assert refusal(tmp_path, f"id,text{',x' * 1_000_000}\na,No.\n".encode(), "lines.csv").code == "sheet_too_large"
    assert time.process_time() - began_s < 5


ENTITIES = "".join(f'<!ENTITY e{n} "{f"&e{n - 1};" * 10 if n else "ha"}">' for n in range(9))


@pytest.mark.parametrize(
    "sheet",
    [
        f"<!DOCTYPE x [{ENTITIES}]>{rows(HEADINGS, '<row>' + cell('A2', '&e8;') + '</row>')}",
        rows(HEADINGS)[:-40],
        f"<worksheet {NAMESPACE}>" + "<sheetData>" * 200_000,
        rows('<row r="one"><c r="??"/></row>'),
        "",
    ],
    ids=["entities", "cut off", "deep", "no places", "empty"],
)
def test_broken_sheets_are_no_workbooks(tmp_path: Path, sheet: str) -> None:
    assert refusal(tmp_path, workbook(sheet)).code in {"sheet_undecodable", "script_empty", "columns_missing"}


@pytest.mark.parametrize(
    "part", ["xl/workbook.xml", "xl/_rels/workbook.xml.rels", "xl/styles.xml", "[Content_Types].xml"]
)
def test_broken_parts_end_in_no_traceback(tmp_path: Path, part: str) -> None:
    for text in ("<", "<x/>", f"<!DOCTYPE x [{ENTITIES}]><x>&e8;</x>"):
        (tmp_path / "lines.xlsx").write_bytes(workbook(None, **{part: text}))
        with suppress(InputError):
            read_script(tmp_path / "lines.xlsx", {})


def test_sheets_of_text_have_the_same_limits(tmp_path: Path) -> None:
    many = "id,text\n" + "a,b\n" * (MOST_ROWS + 1)
    assert refusal(tmp_path, many.encode(), "lines.csv").code == "sheet_too_large"
    wide = "id,text\na,b" + ",x" * MOST_COLUMNS
    assert refusal(tmp_path, wide.encode(), "lines.csv").code == "sheet_too_large"
    long = f'id,text\na,"{"x" * (LONGEST_CELL + 1)}"\n'
    assert refusal(tmp_path, long.encode(), "lines.csv").code in {"sheet_too_large", "sheet_undecodable"}


def test_deep_json_is_a_problem_of_its_line(tmp_path: Path) -> None:
    path = tmp_path / "lines.jsonl"
    path.write_text('{"id": "a", "text": "No."}\n' + "[" * 100_000 + "\n" + '{"a":' * 100_000 + "\n")
    script = read_script(path, {})
    assert len(script.lines) == 1
    assert [(each.row, each.code) for each in script.problems] == [(2, "not_json"), (3, "not_json")]


def test_only_regular_files_are_scripts_and_recordings(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "lines.csv")
    with pytest.raises(InputError) as raised:
        read_script(tmp_path / "lines.csv", {})
    assert raised.value.code == "file_unreadable"
    (tmp_path / "audio").mkdir()
    os.mkfifo(tmp_path / "audio" / "a.wav")
    (tmp_path / "audio" / "b.wav").symlink_to("/dev/zero")
    (tmp_path / "audio" / "c.wav").write_bytes(b"")
    assert [each.stem for each in find_recordings(tmp_path / "audio", without=tmp_path / "out")] == ["c"]


def test_only_regular_files_are_read_that_a_cell_or_a_cast_names(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe.json")
    path = tmp_path / "lines.csv"
    path.write_text("id,text,edits,affect\na,No.,pipe.json,\nb,No.,/dev/zero,\nc,No.,,/dev/../dev/zero.csv\n")
    assert [each.row for each in read_script(path, {}).problems] == [2, 3, 4]
    for cast in (tmp_path / "pipe.json", Path("/dev/zero")):
        with pytest.raises(InputError, match="not a regular file"):
            read_cast(cast, frozenset())


def test_a_time_beyond_all_calendars_is_no_subtitle(tmp_path: Path) -> None:
    cue = b"1\n99999999999:00:00,000 --> 00:00:00,000\nNo.\n"
    assert refusal(tmp_path, cue, "film.srt").code == "subtitles_undecodable"
