"""Every kind of script by its name; workbooks, JSON lines and the exports of engines."""

import io
import json
from pathlib import Path

import pytest
from openpyxl import Workbook

from understudy.batch.model import Script
from understudy.batch.scripts.reading import READERS, read_script
from understudy.errors import InputError
from understudy.model import Level

RENPY = (
    "Identifier\tCharacter\tDialogue\tFilename\tLine Number\tRen'Py Script\n"
    'start_a170\teileen\t{i}No{/i},{w=0.5} [player], not \\"those\\".\tgame/script.rpy\t12\te "[what]"\n'
    "start_b171\t\tNight fell.\tgame/script.rpy\t14\t[what]\n"
)
YARN = (
    "language,id,text,file,node,lineNumber,lock,comment\n"
    'en,line:0a1b,"Anna: [wave]No[/wave], not those {0}. #sad",Start.yarn,Start,4,ffff,softly\n'
)


def read(folder: Path, name: str, content: bytes | str, **named: str) -> Script:
    path = folder / name
    path.write_bytes(content.encode() if isinstance(content, str) else content)
    return read_script(path, named)


def workbook(**sheets: list[list[object]]) -> bytes:
    book = Workbook()
    book.remove(book.worksheets[0])
    for title, rows in sheets.items():
        sheet = book.create_sheet(title)
        for row in rows:
            sheet.append(row)
    content = io.BytesIO()
    book.save(content)
    return content.getvalue()


def test_a_workbook_with_a_cover_and_a_title(tmp_path: Path) -> None:
    lines: list[list[object]] = [
        ["Lights, recording of 3 May"],
        [],
        ["Line No.", "Character", "Dialogue", "Take"],
        [7, "Anna", "No, not those.", 2.0],
        [None, None, None, None],
        [8, "Ben", None, "x"],
    ]
    script = read(tmp_path, "lines.xlsx", workbook(Cover=[["Studio"]], Lines=lines))
    (line,) = script.lines
    assert (line.row, line.id, line.character, line.text, line.take) == (4, "7", "Anna", "No, not those.", 2)
    assert [(problem.row, problem.column) for problem in script.problems] == [
        (6, "D (Take)"),
        (6, "C (Dialogue)"),
    ]
    assert "'Lines'" in script.remarks[0]


def test_json_lines_with_a_line_that_is_none(tmp_path: Path) -> None:
    notes = {"moments": [{"first": 0, "last": 0, "gesture": ["negation"]}]}
    rows = [
        {"id": "a", "text": "No.", "agitation": "low", "listeners": ["Ben", "Cat"], "direction": notes},
        ["b", "Yes."],
        {"id": 3, "text": None},
    ]
    script = read(tmp_path, "lines.jsonl", "\n".join(map(json.dumps, rows)) + "\n\n{\n")
    (line,) = script.lines
    assert (line.id, line.agitation, line.listeners) == ("a", Level.LOW, ("Ben", "Cat"))
    assert line.direction is not None
    assert [(problem.row, problem.column, problem.code) for problem in script.problems] == [
        (2, "", "not_json"),
        (3, "'text'", "text_empty"),
        (5, "", "not_json"),
    ]


def test_what_renpy_exports(tmp_path: Path) -> None:
    script = read(tmp_path, "dialogue.tab", RENPY)
    assert [(line.id, line.character, line.text, line.recording) for line in script.lines] == [
        ("start_a170", "eileen", 'No, player, not "those".', ""),
        ("start_b171", "", "Night fell.", ""),
    ]


def test_what_yarn_spinner_exports(tmp_path: Path) -> None:
    (line,) = read(tmp_path, "strings.csv", YARN).lines
    assert (line.id, line.character, line.text) == ("0a1b", "Anna", "No, not those .")
    assert (line.scene, line.comment, line.recording) == ("Start", "softly", "")


@pytest.mark.parametrize("name", ["lines.doc", "lines"])
def test_another_kind_of_file_is_refused_with_those_that_are_read(name: str, tmp_path: Path) -> None:
    with pytest.raises(InputError) as raised:
        read(tmp_path, name, "x")
    assert raised.value.code == "script_format"
    assert ".fountain" in raised.value.message


@pytest.mark.parametrize("ending", READERS)
def test_an_empty_script_is_told_as_such(ending: str, tmp_path: Path) -> None:
    with pytest.raises(InputError) as raised:
        read(tmp_path, f"lines{ending}", b"")
    assert raised.value.code in {
        "script_empty",
        "sheet_undecodable",
        "screenplay_undecodable",
        "subtitles_undecodable",
    }
