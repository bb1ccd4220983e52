"""Reads CSV files with a header, and reports mistakes with line and column.

Lines and columns count from 1; the header is line 1, and a column is a cell of the header. Case and surrounding spaces
of column names are ignored. The mistakes of all files of answers are reported at once.
"""

import csv
import io
from collections.abc import Collection, Iterable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path

from ...errors import InputError, UndecodableError, did_you_mean, shown

LARGEST_BYTES = 64 << 20


@dataclass(frozen=True, slots=True)
class CellMistake:
    """A mistake in a cell, or in a whole line if `column` is None."""

    path: Path
    line: int
    message: str
    column: int | None = None

    def __str__(self) -> str:
        column = "" if self.column is None else f":{self.column}"
        return f"{self.path}:{self.line}{column}: {self.message}"


@dataclass(frozen=True, slots=True)
class TableRow:
    """A line of the file: its cells by column name, and the number of each column."""

    path: Path
    line: int
    cells: Mapping[str, str]
    places: Mapping[str, int]

    def wrong(self, name: str, message: str) -> CellMistake:
        """A mistake in the row's cell in that column."""
        return CellMistake(self.path, self.line, f"{name}: {message}", self.places.get(name))

    def refused(self, name: str, told: str) -> CellMistake:
        """A mistake whose message shows the cell's value, followed by the correction `told`."""
        return self.wrong(name, f"{shown(self.cells[name])}; {told}")


@dataclass(frozen=True, slots=True)
class Table:
    """The content of a file: its column names in order, case-folded, and its rows."""

    path: Path
    columns: tuple[str, ...]
    rows: tuple[TableRow, ...]

    def require(self, columns: Collection[str]) -> None:
        """Raises AnswersError with every missing column."""
        lacking = [name for name in columns if name not in self.columns]
        if lacking:
            there = ", ".join(self.columns) or "nothing"
            hints = "".join(did_you_mean(name, self.columns) for name in lacking)
            message = f"no column {', '.join(lacking)}; the first line has {there}{hints}"
            raise AnswersError([CellMistake(self.path, 1, message)])


def read_table(path: Path) -> Table:
    """The table in a file.

    Raises InputError `file_unreadable` and `file_too_large`, UndecodableError `text_not_utf8`, and AnswersError for
    lines with more or fewer cells than the header, and for unclosed quotes.
    """
    lines = list(_lines(path, _text(path)))
    header = lines[0][1] if lines else []
    columns = tuple(cell.strip().casefold() for cell in header)
    if len(columns) == 1:
        raise AnswersError([CellMistake(path, 1, f"one column alone, {shown(columns[0])}; answers are CSV")])
    places = {name: place for place, name in enumerate(columns, start=1)}
    if len(places) < len(columns):
        twice = next(name for name in columns if columns.count(name) > 1)
        raise AnswersError([CellMistake(path, 1, f"two columns are called {twice!r}")])
    rows, mistakes = [], []
    for line, cells in lines[1:]:
        if len(cells) != len(columns):
            mistakes.append(CellMistake(path, line, f"{len(cells)} cells, and the first line has {len(columns)}"))
        rows.append(TableRow(path, line, dict(zip(columns, map(str.strip, cells), strict=False)), places))
    if mistakes:
        raise AnswersError(mistakes)
    return Table(path, columns, tuple(rows))


def _text(path: Path) -> str:
    try:
        if path.stat().st_size > LARGEST_BYTES:
            message = f"{path}: larger than {LARGEST_BYTES >> 20} MB; this is not a file of answers"
            raise InputError("file_too_large", message, field="answers")
        return path.read_bytes().decode("utf-8-sig")
    except OSError as error:
        raise InputError("file_unreadable", f"{path}: cannot be read: {error.strerror}", field="answers") from None
    except UnicodeDecodeError as error:
        message = f"{path}: not UTF-8 at byte {error.start}; save it as UTF-8"
        raise UndecodableError("text_not_utf8", message, field="answers") from None


def _lines(path: Path, text: str) -> Iterator[tuple[int, list[str]]]:
    """The non-empty lines with their numbers; cells are separated by commas, semicolons or tabs."""
    first = text.partition("\n")[0]
    separator = max(",;\t", key=first.count)
    reader = csv.reader(io.StringIO(text, newline=""), delimiter=separator, strict=True)
    last = 0
    try:
        for cells in reader:
            if any(cell.strip() for cell in cells):
                yield last + 1, cells
            last = reader.line_num
    except csv.Error as error:
        raise AnswersError([CellMistake(path, last + 1, f"{error}; double each quote within a quoted cell")]) from None


MOST_TOLD = 20


class AnswersError(InputError):
    """Mistakes in files of answers: `mistakes` contains all, the message the first `MOST_TOLD`."""

    names_places = True

    def __init__(self, mistakes: Iterable[CellMistake]) -> None:
        self.mistakes = tuple(mistakes)
        first = list(map(str, self.mistakes[:MOST_TOLD]))
        more = len(self.mistakes) - len(first)
        super().__init__("answers_wrong", "\n".join([*first, *([f"and {more} more"] if more else [])]), field="answers")
