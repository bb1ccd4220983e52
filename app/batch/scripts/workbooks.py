"""Reads sheets in Excel workbooks (.xlsx) with openpyxl: those that are chosen, or the one with the most known headings
and all that have the same."""

import io
import warnings
import zlib
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Protocol
from zipfile import BadZipFile, ZipFile

from openpyxl import load_workbook
from openpyxl.utils.exceptions import InvalidFileException

from ...errors import InputError, TooLargeError, UndecodableError, did_you_mean
from ..model import Script, ScriptLine
from .columns import ColumnNames, folded
from .sheets import (
    ROWS_BEFORE_HEADINGS,
    heading_place,
    read_sheet,
    require_within,
    within_limits,
    without_doubles,
)

LARGEST_UNPACKED_BYTES = 96 << 20
"""The parts of a workbook together; 50,000 lines with 15 columns take about half."""

MOST_SHEETS = 200

MOST_READ_ROWS, MOST_READ_CELLS = 1 << 20, 4_000_000
"""Of a worksheet, with empty ones: as many rows as Excel has, and the cells of half a minute's reading."""

_CONTENTS = "xl/workbook.xml"

_BROKEN = (
    *(BadZipFile, InvalidFileException, zlib.error, EOFError, OSError),
    *(KeyError, IndexError, ValueError, TypeError, AttributeError),  # what openpyxl meets in XML of another form
    SyntaxError,  # XML that is not well-formed, or expands entities beyond measure
    RuntimeError,  # a part that is encrypted or too deep
)


class _Sheet(Protocol):
    """A worksheet as openpyxl reads it row by row."""

    def reset_dimensions(self) -> None: ...

    def iter_rows(self, *, values_only: bool) -> Iterator[tuple[object, ...]]: ...


def read_workbook(content: bytes, path: Path, named: Mapping[str, str], *, chosen: Sequence[str] = ()) -> Script:
    """The script in a workbook: in the worksheets that are `chosen`, or in all that look alike. Raises UndecodableError
    `sheet_undecodable`, TooLargeError `sheet_too_large`, InputError `script_empty`, `columns_missing` and
    `sheet_missing`."""
    names = ColumnNames.load()
    sheets = _worksheets(content, path)
    if not sheets:
        raise InputError("script_empty", f"{path}: no worksheet in it; give one with a row of headings", field="script")
    titles = _chosen(sheets, chosen, path) or _alike(sheets, names, named)
    left_out = [title for title in sheets if title not in titles]
    remark = f"{path}: read worksheets {_listed(titles)}; left out {_listed(left_out)} (--sheet chooses)"
    scripts = [(title, read_sheet(sheets[title], path, names=names, named=named)) for title in titles]
    return _together(scripts, path, [remark] if left_out else [])


def _chosen(sheets: Mapping[str, object], chosen: Sequence[str], path: Path) -> list[str]:
    """The titles of the chosen sheets, in the workbook's order."""
    by_name = {title.strip().casefold(): title for title in sheets}
    for name in chosen:
        if name.strip().casefold() not in by_name:
            message = f"{path}: no worksheet is called {name!r}{did_you_mean(name, tuple(sheets))}"
            raise InputError("sheet_missing", f"{message}; there are {_listed(sheets)}", field="sheet")
    wanted = {by_name[name.strip().casefold()] for name in chosen}
    return [title for title in sheets if title in wanted]


def _alike(sheets: Mapping[str, list[list[str]]], names: ColumnNames, named: Mapping[str, str]) -> list[str]:
    """The worksheet with the most known headings, and all that have the same fields."""
    headers = {title: _header(rows, names, named) for title, rows in sheets.items()}
    known = {title: _known(header, names, named) for title, header in headers.items()}
    best = max(sheets, key=lambda title: len(known[title]))
    return [title for title in sheets if title == best or (known[best] and known[title] == known[best])]


def _known(header: Sequence[str], names: ColumnNames, named: Mapping[str, str]) -> frozenset[str]:
    """The headings of a sheet that are known or named, as they are compared."""
    wanted = {folded(heading) for heading in named.values()}
    cells = {folded(cell) for cell in header}
    return frozenset(cell for cell in cells if cell in wanted or names.recognised([cell]))


def _together(scripts: Sequence[tuple[str, Script]], path: Path, remarks: Sequence[str]) -> Script:
    """The lines of several sheets, one after the other; each is a scene of its own where the script has no scenes."""
    if len(scripts) == 1:
        ((_title, script),) = scripts
        return replace(script, remarks=(*script.remarks, *remarks))
    lines = [_of_sheet(line, title, script) for title, script in scripts for line in script.lines]
    kept, doubles = without_doubles(lines, "")
    problems = [replace(each, sheet=title) for title, script in scripts for each in script.problems]
    return Script(path, kept, (*problems, *doubles), tuple(remarks), scripts[0][1].columns)


def _of_sheet(line: ScriptLine, title: str, script: Script) -> ScriptLine:
    """A line of one of several sheets; ids that are mere row numbers begin with the sheet."""
    has_id = line.recording or any(field == "id" for field, _heading in script.columns)
    return replace(line, sheet=title, scene=line.scene or title, id=line.id if has_id else f"{title}_{line.id}")


def _listed(titles: Iterable[str]) -> str:
    return ", ".join(map(repr, titles))


def _worksheets(content: bytes, path: Path) -> dict[str, list[list[str]]]:
    """The rows of each worksheet; a formula is the value stored for it."""
    try:
        _require_small(content, path)
        with warnings.catch_warnings(action="ignore"):  # about styles and extensions, which are not read
            workbook = load_workbook(io.BytesIO(content), read_only=True, data_only=True)
            return {
                sheet.title: list(_rows(sheet, path)) for sheet in workbook.worksheets if hasattr(sheet, "iter_rows")
            }
    except _BROKEN as error:
        message = f"{path}: not an Excel workbook: {(str(error) or type(error).__name__).splitlines()[0]}"
        raise UndecodableError("sheet_undecodable", f"{message}; save it as .xlsx or .csv", field="script") from None


def _require_small(content: bytes, path: Path) -> None:
    """Raises TooLargeError `sheet_too_large` for a sheet that unpacks to more than a person could have typed."""
    with ZipFile(io.BytesIO(content)) as packed:
        unpacked = sum(part.file_size for part in packed.infolist())
        is_small = unpacked <= LARGEST_UNPACKED_BYTES
        sheets = packed.read(_CONTENTS).count(b"sheetId=") if is_small and _CONTENTS in packed.namelist() else 0
    if sheets > MOST_SHEETS:
        message = f"{path}: has {sheets:,} worksheets; at most {MOST_SHEETS} are read"
        raise TooLargeError("sheet_too_large", f"{message}; divide it, or save one as .csv", field="script")
    if unpacked > LARGEST_UNPACKED_BYTES:
        message = f"{path}: unpacks to {unpacked >> 20} MB; at most {LARGEST_UNPACKED_BYTES >> 20} are read"
        raise TooLargeError("sheet_too_large", f"{message}; divide it, or save it as .csv", field="script")


def _rows(sheet: _Sheet, path: Path) -> list[list[str]]:
    """The rows, as wide as their content, whatever dimensions the sheet states; the first ones, which include the
    headings, as wide as the widest."""
    sheet.reset_dimensions()
    rows = list(within_limits(map(_cells, _counted(sheet.iter_rows(values_only=True), path)), path))
    width = max(map(len, rows), default=0)
    for cells in [row for row in rows if row][:ROWS_BEFORE_HEADINGS]:
        cells.extend([""] * (width - len(cells)))
    return rows


def _counted(rows: Iterable[tuple[object, ...]], path: Path) -> Iterator[tuple[object, ...]]:
    """The rows as they come, empty ones and empty cells too. Raises TooLargeError `sheet_too_large`."""
    cells = 0
    for number, row in enumerate(rows, start=1):
        cells += len(row)
        limits = ((number, MOST_READ_ROWS, "rows"), (cells, MOST_READ_CELLS, "cells, empty ones too,"))
        require_within(limits, path, number)
        yield row


def _cells(row: tuple[object, ...]) -> list[str]:
    """The cells of a row as text, without empty ones at its end."""
    cells = ["" if cell is None else _told(cell) for cell in row]
    while cells and not cells[-1]:
        cells.pop()
    return cells


def _told(cell: object) -> str:
    """The cell as text; a whole number as shown, because 3 is stored as 3.0."""
    return str(int(cell)) if isinstance(cell, float) and cell.is_integer() else str(cell)


def _header(rows: list[list[str]], names: ColumnNames, named: Mapping[str, str]) -> list[str]:
    first = [cells for cells in rows if any(cells)][:ROWS_BEFORE_HEADINGS]
    return first[heading_place(first, names, named)] if first else []
