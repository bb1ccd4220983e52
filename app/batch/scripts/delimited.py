"""Reads sheets as text: CSV and TSV, with any of several separators, and JSON lines, an object a line whose keys are
the columns.

The separator is the one with which the header has the most known names, then the most cells: lines of dialogue have
more commas than a sheet has columns, so counting separators would mislead.
"""

import csv
import io
import json
from collections.abc import Iterator, Mapping
from dataclasses import replace
from pathlib import Path

from ...errors import UndecodableError, why_not_json
from ..model import RowProblem, Script
from .columns import ColumnNames, find_columns
from .sheets import (
    LONGEST_CELL,
    MOST_COLUMNS,
    ROWS_BEFORE_HEADINGS,
    heading_place,
    read_lines,
    read_sheet,
    within_limits,
)
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
            rows = [row[:MOST_COLUMNS] for row in csv.reader(first, delimiter=separator)]
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


def read_json_lines(content: bytes, path: Path, named: Mapping[str, str]) -> Script:
    """The script in a file of JSON lines; a line that is not an object is reported as a problem. Raises
    UndecodableError `text_not_utf8`, InputError `columns_missing`."""
    file = decode_text(content, str(path))
    objects: dict[int, dict[str, object]] = {}
    problems = []
    for number, line in enumerate(file.text.splitlines(), start=1):
        if line.strip():
            try:
                objects[number] = _object(line)
            except ValueError as error:
                problems.append(RowProblem(number, "", "not_json", str(error)))
    keys = list(dict.fromkeys(key for each in objects.values() for key in each))
    if not objects:
        return Script(path, (), tuple(problems))
    columns = replace(find_columns(keys, ColumnNames.load(), named, file=str(path)), has_letters=False)
    rows = ((number, [_told(each.get(key)) for key in keys]) for number, each in objects.items())
    script = read_lines(rows, columns, path, [file.remark] if file.remark else [])
    return replace(script, problems=tuple(sorted([*problems, *script.problems], key=lambda each: each.row)))


def _object(line: str) -> dict[str, object]:
    try:
        value = json.loads(line)
    except (ValueError, RecursionError) as error:
        raise ValueError(why_not_json(error)) from None
    if not isinstance(value, dict):
        raise ValueError("no JSON object in braces")
    return value


def _told(value: object) -> str:
    """A value as a sheet would have it: lists of names with commas, a director's notes as JSON."""
    if value is None:
        return ""
    if isinstance(value, list) and all(isinstance(each, str) for each in value):
        return ", ".join(value)
    return value if isinstance(value, str) else json.dumps(value)
