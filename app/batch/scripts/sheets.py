"""Reads a voice-over sheet from rows of cells: one row a line, after a row of headings. Problems of cells are
collected, not raised, so that all are reported.
"""

import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path, PurePath
from types import MappingProxyType
from typing import TypeVar

from ...errors import InputError, TooLargeError
from ...files import read_regular
from ...model import AffectTrack, Direction, Interval, Level, Target
from ...model.edits import Edits
from ...model.targets import read_targets
from ...schemas.affect import read_affect, read_affect_track
from ...schemas.direction import read_direction
from ...schemas.edits import read_edits
from ..model import RowProblem, Script, ScriptLine, place_told
from .columns import ColumnNames, Columns, find_columns, folded
from .text_files import with_name

Read = TypeVar("Read")

_CLOCK = re.compile(r"(?:(?:(\d+):)?(\d+):)?(\d+(?:[.,]\d+)?)")
_SEPARATORS = re.compile(r"[;,|/]")


@dataclass(slots=True)
class Row:
    """A row being read: its cells by field, and the problems found so far."""

    number: int
    cells: Sequence[str]
    columns: Columns
    folder: Path
    problems: list[RowProblem] = field(default_factory=list)

    def text(self, name: str) -> str:
        """The cell without surrounding white space; empty where there is none."""
        place = self.columns.places.get(name)
        return self.cells[place].strip() if place is not None and place < len(self.cells) else ""

    def whole_number(self, name: str) -> int | None:
        """A whole number, also as 3.0, which is how spreadsheets write 3."""
        text = self.text(name)
        match = re.fullmatch(r"[^\d-]*(-?\d{1,18})(?:\.0*)?", text)
        if text and match is None:
            self.wrong(name, "value_wrong", f"{text!r} is not a whole number")
        return int(match[1]) if match else None

    def level(self) -> Level | None:
        text = self.text("agitation").casefold()
        if text and text not in set(Level):
            self.wrong("agitation", "value_wrong", f"{text!r}; it is low, medium or high, or empty")
            return None
        return Level(text) if text else None

    def affect(self) -> AffectTrack | None:
        """A tone, activation, valence and dominance, or the name of a track beside the script."""
        text = self.text("affect")
        if not text:
            return None
        try:
            if text.casefold().endswith(".csv"):
                return read_affect_track(read_regular(self.folder / text), text)
            return read_affect(text.casefold())
        except InputError as error:
            self.wrong("affect", error.code, error.message)
        except OSError as error:
            self.wrong("affect", "file_unreadable", f"{text}: cannot be read: {error.strerror}")
        return None

    def interval(self) -> Interval | None:
        """The times, in seconds or h:mm:ss.ms; both start and end, or None."""
        ends = [self._seconds(name) for name in ("start", "end")]
        if ends == [None, None]:
            return None
        if ends[0] is None or ends[1] is None or ends[0] >= ends[1]:
            name = "end" if "end" in self.columns.places else "start"
            self.wrong(name, "value_wrong", "a line that is cut out needs its start and a later end")
            return None
        return Interval(ends[0], ends[1])

    def listeners(self) -> tuple[str, ...] | None:
        told = self.text("listener")
        return tuple(name.strip() for name in _SEPARATORS.split(told) if name.strip()) if told else None

    def targets(self) -> tuple[Target, ...]:
        """The targets: NAME=X,Y,Z, several separated by semicolons."""
        try:
            return read_targets(part for part in self.text("target").split(";") if part.strip())
        except InputError as error:
            self.wrong("target", error.code, error.message)
            return ()

    def direction(self) -> tuple[Direction | None, str]:
        """A director's notes, as JSON or the name of a .json file beside the script; anything else is a comment."""
        told = self.text("direction")
        if not told.startswith("{") and not told.casefold().endswith(".json"):
            return None, told
        return self._json("direction", read_direction), ""

    def edits(self) -> Edits | None:
        """An author's edits, as JSON or the name of a file beside the script."""
        return self._json("edits", read_edits) if self.text("edits") else None

    def _json(self, name: str, read: Callable[[bytes], Read]) -> Read | None:
        """What a cell contains as JSON, or what the file named in it contains; None if that is wrong."""
        text = self.text(name)
        try:
            return read(text.encode() if text.startswith("{") else read_regular(self.folder / text))
        except InputError as error:
            self.wrong(name, error.code, error.message)
        except OSError as error:
            self.wrong(name, "file_unreadable", f"{text}: cannot be read: {error.strerror}")
        return None

    def wrong(self, name: str, code: str, message: str) -> None:
        column = self.columns.name(name) if name in self.columns.places else ""
        self.problems.append(RowProblem(self.number, column, code, message, self.text("id")))

    def _seconds(self, name: str) -> float | None:
        text = self.text(name)
        if not text:
            return None
        match = _CLOCK.fullmatch(text)
        if match is None:
            self.wrong(name, "value_wrong", f"{text!r} is not a time; give seconds or h:mm:ss.ms")
            return None
        hours, minutes, seconds = (float((part or "0").replace(",", ".")) for part in match.groups())
        return 3600 * hours + 60 * minutes + seconds


Cells = Sequence[str]

ROWS_BEFORE_HEADINGS = 10

MOST_ROWS = 200_000
MOST_COLUMNS = 500
MOST_CELLS = 4_000_000

LONGEST_CELL = 1 << 20
"""The most of a sheet that is read, rows and cells without empty ones; nobody's script comes near."""


def within_limits(rows: Iterable[list[str]], path: Path) -> Iterator[list[str]]:
    """The rows as they come. Raises TooLargeError `sheet_too_large`."""
    filled = cells = 0
    for number, row in enumerate(rows, start=1):
        width = next((place for place in range(len(row), 0, -1) if row[place - 1]), 0)
        filled, cells = filled + (width > 0), cells + width
        longest = max(map(len, row), default=0)
        limits = (
            (filled, MOST_ROWS, "rows"),
            (width, MOST_COLUMNS, "columns"),
            (cells, MOST_CELLS, "cells"),
            (longest, LONGEST_CELL, "letters in a cell"),
        )
        require_within(limits, path, number)
        yield row[:MOST_COLUMNS]


def require_within(limits: Iterable[tuple[int, int, str]], path: Path, row: int) -> None:
    """Raises TooLargeError `sheet_too_large` for the first count that is above the most there may be of something."""
    for count, most, what in limits:
        if count > most:
            message = f"{path}: more than {most:,} {what} by row {row}; divide it, or delete other rows"
            raise TooLargeError("sheet_too_large", message, field="script")


def read_sheet(
    rows: Iterable[Cells], path: Path, *, names: ColumnNames, named: Mapping[str, str], remarks: Sequence[str] = ()
) -> Script:
    """The lines of a sheet; empty rows are skipped. Raises InputError `script_empty` and `columns_missing`."""
    numbered = [(number, cells) for number, cells in enumerate(rows, start=1) if any(cell.strip() for cell in cells)]
    if not numbered:
        raise InputError("script_empty", f"{path}: it is empty; give a row of headings, then one row for each line")
    place = heading_place([cells for _number, cells in numbered[:ROWS_BEFORE_HEADINGS]], names, named)
    header = numbered[place][1]
    dialect = None if named else dialect_of(header)
    columns = dialect.columns(header) if dialect else find_columns(header, names, named, file=str(path))
    script = read_lines(numbered[place + 1 :], columns, path, remarks)
    return script if dialect is None else replace(script, lines=tuple(map(dialect.plain, script.lines)))


def read_lines(rows: Iterable[tuple[int, Cells]], columns: Columns, path: Path, remarks: Sequence[str] = ()) -> Script:
    """The lines of numbered rows."""
    read = [_read_row(Row(number, cells, columns, path.parent)) for number, cells in rows]
    lines = [line for line, problems in read if not problems]
    kept, doubles = without_doubles(lines, columns.name("id") if "id" in columns.places else "")
    problems = [*(problem for _line, found in read for problem in found), *doubles]
    ordered = tuple(sorted(problems, key=lambda each: each.row))
    return Script(path, kept, ordered, tuple(remarks), columns.told())


def heading_place(rows: Sequence[Cells], names: ColumnNames, named: Mapping[str, str]) -> int:
    """The position of the row with the headings: the one with the most known names, the first of several; if none has
    any, the fullest, since a title is one cell."""
    headings = {folded(heading) for heading in named.values()}
    known = [names.recognised(cells) + sum(folded(cell) in headings for cell in cells) for cells in rows]
    if not any(known):
        known = [sum(bool(cell.strip()) for cell in cells) for cells in rows]
    return known.index(max(known))


def without_doubles(lines: Sequence[ScriptLine], column: str) -> tuple[tuple[ScriptLine, ...], list[RowProblem]]:
    """The lines whose id does not repeat an earlier one (without case, as in file names), and a problem for each of the
    others."""
    first: dict[str, ScriptLine] = {}
    kept, problems = [], []
    for line in lines:
        earlier = first.setdefault(line.id.casefold(), line)
        if earlier is line:
            kept.append(line)
        else:
            place = place_told(earlier.row, earlier.sheet)
            message = f"{line.id!r} is {place}'s already; give each line its own id"
            problems.append(RowProblem(line.row, column, "id_repeated", message, line.id, line.sheet))
    return tuple(kept), problems


def _read_row(row: Row) -> tuple[ScriptLine, list[RowProblem]]:
    direction, told = row.direction()
    line = ScriptLine(
        row=row.number,
        id=_id(row),
        text=" ".join(row.text("text").split()),
        character=row.text("character"),
        recording=row.text("recording"),
        comment="; ".join(part for part in (row.text("comment"), told) if part),
        scene=row.text("scene"),
        take=row.whole_number("take"),
        interval=row.interval(),
        direction=direction,
        edits=row.edits(),
        listeners=row.listeners(),
        agitation=row.level(),
        affect=row.affect(),
        seed=row.whole_number("seed"),
        targets=row.targets(),
    )
    if not line.text:
        row.wrong("text", "text_empty", "no words; write what is spoken")
    if len(row.cells) > len(row.columns.header) and any(cell.strip() for cell in row.cells[len(row.columns.header) :]):
        message = (
            f"{len(row.cells)} cells under {len(row.columns.header)} headings; quote text that contains separators"
        )
        row.problems.append(RowProblem(row.number, "", "row_too_long", message, line.id))
    return line, row.problems


def _id(row: Row) -> str:
    """The line's own id, else the stem of the recording that it names, else its row number."""
    if "id" not in row.columns.places:
        return PurePath(row.text("recording").replace("\\", "/")).stem or f"row{row.number:05d}"
    text = row.text("id")
    if not text:
        row.wrong("id", "id_missing", "no id; give each line one of its own")
    return text


_RENPY_TAG = re.compile(r"\{(?!\{)[^{}]*\}")
_RENPY_NAME = re.compile(r"\[(?!\[)([^\[\]]*)\]")
_YARN_MARK = re.compile(r"\[/?[^\]]*\]|\{[^}]*\}|\s#\S+")
_YARN_PREFIX = "line:"


@dataclass(frozen=True, slots=True)
class SheetDialect:
    """An export format: the headings by which it is recognized, the headings of its fields, and the conversion of its
    lines."""

    signature: frozenset[str]
    fields: Mapping[str, str]
    plain: Callable[[ScriptLine], ScriptLine]

    def columns(self, header: Sequence[str]) -> Columns:
        places = {folded(cell): place for place, cell in enumerate(header)}
        found = {field: places[folded(name)] for field, name in self.fields.items() if folded(name) in places}
        return Columns(tuple(header), MappingProxyType(found))


def _of_renpy(line: ScriptLine) -> ScriptLine:
    """The line without text tags; an interpolated name is taken for the word that is spoken."""
    plain = _RENPY_NAME.sub(r"\1", _RENPY_TAG.sub("", line.text)).replace('\\"', '"').replace("\\n", " ")
    return replace(line, text=" ".join(plain.replace("{{", "{").replace("[[", "[").split()))


def _of_yarn(line: ScriptLine) -> ScriptLine:
    """The line without markup; its id without "line:" is the name of its recordings."""
    name, words = with_name(_YARN_MARK.sub("", line.text))
    return replace(line, id=line.id.removeprefix(_YARN_PREFIX), character=name, text=" ".join(words.split()))


DIALECTS = (
    SheetDialect(
        frozenset({"identifier", "character", "dialogue", "filename"}),
        {"id": "Identifier", "character": "Character", "text": "Dialogue"},
        _of_renpy,
    ),
    SheetDialect(
        frozenset({"id", "text", "file", "node", "linenumber"}),
        {"id": "id", "text": "text", "scene": "node", "comment": "comment"},
        _of_yarn,
    ),
)


def dialect_of(header: Sequence[str]) -> SheetDialect | None:
    """The export format that a header belongs to; None for any other sheet."""
    names = {folded(cell) for cell in header}
    return next((dialect for dialect in DIALECTS if dialect.signature <= names), None)
