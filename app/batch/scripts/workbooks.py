"""Reads sheets in Excel workbooks (.xlsx) with openpyxl: the worksheet with the most known headings."""

import io
import warnings
import zlib
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Protocol
from zipfile import BadZipFile, ZipFile

from openpyxl import load_workbook
from openpyxl.utils.exceptions import InvalidFileException

from ...errors import InputError, TooLargeError, UndecodableError
from ..model import Script
from .columns import ColumnNames
from .sheets import ROWS_BEFORE_HEADINGS, heading_place, read_sheet, within_limits

LARGEST_UNPACKED_BYTES = 96 << 20
"""The parts of a workbook together; 50,000 lines with 15 columns take about half."""

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


def read_workbook(content: bytes, path: Path, named: Mapping[str, str]) -> Script:
    """The script in a workbook. Raises UndecodableError `sheet_undecodable`, InputError `script_empty` and
    `columns_missing`."""
    names = ColumnNames.load()
    sheets = _worksheets(content, path)
    if not sheets:
        raise InputError("script_empty", f"{path}: no worksheet in it; give one with a row of headings", field="script")
    title = max(sheets, key=lambda each: _headings(sheets[each], names, named))
    remarks = [f"{path}: worksheet {title!r} of {', '.join(map(repr, sheets))}"] if len(sheets) > 1 else []
    return read_sheet(sheets[title], path, names=names, named=named, remarks=remarks)


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
        message = f"{path}: no Excel workbook: {(str(error) or type(error).__name__).splitlines()[0]}"
        raise UndecodableError("sheet_undecodable", f"{message}; save it as .xlsx or .csv", field="script") from None


def _require_small(content: bytes, path: Path) -> None:
    """Raises TooLargeError `sheet_too_large` for what unpacks to more than anybody has typed."""
    with ZipFile(io.BytesIO(content)) as packed:
        unpacked = sum(part.file_size for part in packed.infolist())
    if unpacked > LARGEST_UNPACKED_BYTES:
        message = f"{path}: unpacks to {unpacked >> 20} MB; at most {LARGEST_UNPACKED_BYTES >> 20} are read"
        raise TooLargeError("sheet_too_large", f"{message}; divide it, or save it as .csv", field="script")


def _rows(sheet: _Sheet, path: Path) -> list[list[str]]:
    """The rows, as wide as what is in them, whatever dimensions the sheet claims; the first ones, among which the
    headings are, as wide as the widest."""
    sheet.reset_dimensions()
    rows = list(within_limits((_cells(row) for row in sheet.iter_rows(values_only=True)), path))
    width = max(map(len, rows), default=0)
    for cells in [row for row in rows if row][:ROWS_BEFORE_HEADINGS]:
        cells.extend([""] * (width - len(cells)))
    return rows


def _cells(row: tuple[object, ...]) -> list[str]:
    """The cells of a row as text, without empty ones at its end."""
    cells = ["" if cell is None else _told(cell) for cell in row]
    while cells and not cells[-1]:
        cells.pop()
    return cells


def _told(cell: object) -> str:
    """The cell as text; a whole number as shown, because 3 is stored as 3.0."""
    return str(int(cell)) if isinstance(cell, float) and cell.is_integer() else str(cell)


def _headings(rows: list[list[str]], names: ColumnNames, named: Mapping[str, str]) -> int:
    first = [cells for cells in rows if any(cells)][:ROWS_BEFORE_HEADINGS]
    if not first:
        return -1
    header = first[heading_place(first, names, named)]
    return names.recognised(header) + sum(cell in named.values() for cell in header)
