"""CSV files with a header: their cells by column, and what is wrong with them, by line and column of the file.

Lines and columns count from 1, the header being line 1 and a column a cell of it. Column names ignore case and spaces.

All files of answers are checked at once.
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
    """What is wrong with a cell, or with a whole line where `column` is None."""

    path: Path
    line: int
    message: str
    column: int | None = None

    def __str__(self) -> str:
        column = "" if self.column is None else f":{self.column}"
        return f"{self.path}:{self.line}{column}: {self.message}"


@dataclass(frozen=True, slots=True)
class TableRow:
    """A line of the file: its cells by column name, and where each column stands."""

    path: Path
    line: int
    cells: Mapping[str, str]
    places: Mapping[str, int]

    def wrong(self, name: str, message: str) -> CellMistake:
        """A mistake in the cell of that column."""
        return CellMistake(self.path, self.line, f"{name}: {message}", self.places.get(name))

    def refused(self, name: str, told: str) -> CellMistake:
        """A mistake that shows what is there and says what would be right."""
        return self.wrong(name, f"{shown(self.cells[name])}; {told}")


@dataclass(frozen=True, slots=True)
class Table:
    """A file: its columns in order, folded, and its rows."""

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

    Raises InputError `file_unreadable`, UndecodableError `text_not_utf8`, AnswersError for lines that have no more or
    fewer cells than the header, and for quotes that never end.
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
            message = f"{path}: larger than {LARGEST_BYTES >> 20} MB; these are no answers"
            raise InputError("file_too_large", message, field="answers")
        return path.read_bytes().decode("utf-8-sig")
    except OSError as error:
        raise InputError("file_unreadable", f"{path}: cannot be read: {error.strerror}", field="answers") from None
    except UnicodeDecodeError as error:
        message = f"{path}: not UTF-8 at byte {error.start}; save it as UTF-8"
        raise UndecodableError("text_not_utf8", message, field="answers") from None


def _lines(path: Path, text: str) -> Iterator[tuple[int, list[str]]]:
    """The lines that are not empty with their numbers; spreadsheets may have put semicolons for commas."""
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
    """Files of answers that do not hold together: `mistakes` has every one, the message the first twenty."""

    def __init__(self, mistakes: Iterable[CellMistake]) -> None:
        self.mistakes = tuple(mistakes)
        told = list(map(str, self.mistakes[:MOST_TOLD]))
        more = len(self.mistakes) - len(told)
        super().__init__("answers_wrong", "\n".join([*told, *([f"and {more} more"] if more else [])]), field="answers")
