"""Reads sheets in Excel workbooks (.xlsx) with openpyxl: the worksheet with the most known headings."""

import io
import warnings
from collections.abc import Iterator, Mapping
from pathlib import Path
from zipfile import BadZipFile

from openpyxl import load_workbook
from openpyxl.utils.exceptions import InvalidFileException

from ...errors import UndecodableError
from ..model import Script
from .columns import ColumnNames
from .sheets import ROWS_BEFORE_HEADINGS, heading_place, read_sheet


def read_workbook(content: bytes, path: Path, named: Mapping[str, str]) -> Script:
    """The script in a workbook. Raises UndecodableError `sheet_undecodable`, InputError `script_empty` and
    `columns_missing`."""
    names = ColumnNames.load()
    sheets = _worksheets(content, path)
    title = max(sheets, key=lambda each: _headings(sheets[each], names, named))
    remarks = [f"{path}: worksheet {title!r} of {', '.join(map(repr, sheets))}"] if len(sheets) > 1 else []
    return read_sheet(sheets[title], path, names=names, named=named, remarks=remarks)


def _worksheets(content: bytes, path: Path) -> dict[str, list[list[str]]]:
    """The rows of each worksheet; a formula is the value stored for it."""
    try:
        with warnings.catch_warnings(action="ignore"):  # about styles and extensions, which are not read
            workbook = load_workbook(io.BytesIO(content), read_only=True, data_only=True)
            return {sheet.title: list(_rows(sheet.iter_rows(values_only=True))) for sheet in workbook.worksheets}
    except (BadZipFile, InvalidFileException, KeyError, ValueError, OSError) as error:
        message = f"{path}: no Excel workbook: {error}; save it as .xlsx or .csv"
        raise UndecodableError("sheet_undecodable", message, field="script") from None


def _rows(rows: Iterator[tuple[object, ...]]) -> Iterator[list[str]]:
    for cells in rows:
        yield ["" if cell is None else _told(cell) for cell in cells]


def _told(cell: object) -> str:
    """The cell as text; a whole number as shown, because 3 is stored as 3.0."""
    return str(int(cell)) if isinstance(cell, float) and cell.is_integer() else str(cell)


def _headings(rows: list[list[str]], names: ColumnNames, named: Mapping[str, str]) -> int:
    first = [cells for cells in rows if any(cells)][:ROWS_BEFORE_HEADINGS]
    if not first:
        return -1
    header = first[heading_place(first, names, named)]
    return names.recognised(header) + sum(cell in named.values() for cell in header)
