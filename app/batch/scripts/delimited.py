"""Reads sheets as text: CSV and TSV, with any of several separators.

The separator is the one with which the header has the most known names, then the most cells: lines of dialogue have
more commas than a sheet has columns, so counting separators would mislead.
"""

import csv
import io
from collections.abc import Iterator, Mapping
from pathlib import Path

from ...errors import UndecodableError
from ..model import Script
from .columns import ColumnNames
from .sheets import LONGEST_CELL, ROWS_BEFORE_HEADINGS, heading_place, read_sheet, within_limits
from .text_files import decode_text

SEPARATORS = (",", ";", "\t", "|")


def read_delimited(content: bytes, path: Path, named: Mapping[str, str]) -> Script:
    """The script in a CSV or TSV file. Raises UndecodableError `text_not_utf8` and `sheet_undecodable`, InputError
    `script_empty` and `columns_missing`."""
    file = decode_text(content, str(path))
    names = ColumnNames.load()
    rows = within_limits(read_rows(file.text, separator_of(file.text, names, named), path), path)
    return read_sheet(rows, path, names=names, named=named, remarks=[file.remark] if file.remark else [])


def separator_of(text: str, names: ColumnNames, named: Mapping[str, str]) -> str:
    """The separator of the cells in the first rows."""
    first = [line for line in text.splitlines() if line.strip()][:ROWS_BEFORE_HEADINGS]

    def headings(separator: str) -> tuple[int, int]:
        try:
            rows = list(csv.reader(first, delimiter=separator))
        except csv.Error:
            return 0, 0
        cells = rows[heading_place(rows, names, named)] if rows else []
        return names.recognised(cells) + sum(cell in named.values() for cell in cells), len(cells)

    return max(SEPARATORS, key=headings)


def read_rows(text: str, separator: str, path: Path) -> Iterator[list[str]]:
    """The rows of cells. Raises UndecodableError `sheet_undecodable` with the line, for example for a quote that is not
    closed."""
    csv.field_size_limit(LONGEST_CELL)
    reader = csv.reader(io.StringIO(text, newline=""), delimiter=separator, strict=True)
    last = 0
    try:
        for cells in reader:
            yield cells
            last = reader.line_num
    except csv.Error as error:
        message = f"{path}: the row from line {last + 1} on: {error}; double each quote within a quoted cell"
        raise UndecodableError("sheet_undecodable", message, field="script") from None
