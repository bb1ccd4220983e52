"""Voice-over sheets: tables as text, one line a row, columns found by their usual headings."""

import csv
import io
import re
from collections.abc import Sequence

from .model import ScriptError, ScriptLine

_HEADINGS = {
    "text": ("text", "dialogue", "dialog", "words", "script", "transcript", "subtitle", "line"),
    "id": ("id", "line id", "key", "line no", "line number", "cue", "vo", "vo id", "audio id", "line #", "line"),
    "character": ("character", "speaker", "role", "name", "voice", "actor"),
    "audio": ("audio", "file", "filename", "file name", "recording", "wav", "sound"),
}
"""Headings of each field, the surest first. A column has one field, the words before the id."""
_DELIMITERS = ",;\t"
_HIGHEST_HEADING = 5
"""Headings are in one of the first rows; titles may stand above them."""


def read_sheet(content: str, name: str) -> tuple[ScriptLine, ...]:
    """The lines of a table. Raises ScriptError where no column has the words."""
    delimiter = max(_DELIMITERS, key=content.partition("\n")[0].count)
    rows = [[cell.strip() for cell in row] for row in csv.reader(io.StringIO(content, newline=""), delimiter=delimiter)]
    for place, row in enumerate(rows[:_HIGHEST_HEADING]):
        columns = _columns(row)
        if len(columns) > 1 and "text" in columns:
            return tuple(
                ScriptLine(
                    _cell(cells, columns.get("id")) or f"{name}_{number:04}",
                    _cell(cells, columns["text"]),
                    _cell(cells, columns.get("character")),
                    audio=_cell(cells, columns.get("audio")),
                )
                for number, cells in enumerate(rows[place + 1 :], start=1)
                if _cell(cells, columns["text"])
            )
    headings = ", ".join(repr(cell) for row in rows[:1] for cell in row if cell) or "nothing"
    raise ScriptError(f"no column has the words of the lines ({headings}): call it 'Text'")


def _columns(row: Sequence[str]) -> dict[str, int]:
    """The place of each field whose heading a row has."""
    there = {re.sub(r"[\s_.-]+", " ", cell).strip().lower(): place for place, cell in reversed(list(enumerate(row)))}
    found: dict[str, int] = {}
    for field, headings in _HEADINGS.items():
        place = next((there[each] for each in headings if each in there and there[each] not in found.values()), None)
        if place is not None:
            found[field] = place
    return found


def _cell(row: Sequence[str], place: int | None) -> str:
    return " ".join(row[place].split()) if place is not None and place < len(row) else ""
