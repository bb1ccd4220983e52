"""Turns the cells of a row into the fields of a line; problems are collected, not raised, so that all are reported."""

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import TypeVar

from ...errors import InputError
from ...model import AffectTrack, Direction, Interval, Level, Target
from ...model.edits import Edits
from ...model.targets import read_targets
from ...schemas.affect import read_affect, read_affect_track
from ...schemas.direction import read_direction
from ...schemas.edits import read_edits
from ..model import RowProblem
from .columns import Columns

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
        told = self.text(name)
        match = re.fullmatch(r"[^\d-]*(-?\d{1,18})(?:\.0*)?", told)
        if told and match is None:
            self.wrong(name, "value_wrong", f"{told!r} is no whole number")
        return int(match[1]) if match else None

    def level(self) -> Level | None:
        told = self.text("agitation").casefold()
        if told and told not in set(Level):
            self.wrong("agitation", "value_wrong", f"{told!r}; it is low, medium or high, or empty")
            return None
        return Level(told) if told else None

    def affect(self) -> AffectTrack | None:
        """A tone, activation, valence and dominance, or the name of a track beside the script."""
        told = self.text("affect")
        if not told:
            return None
        try:
            if told.casefold().endswith(".csv"):
                return read_affect_track((self.folder / told).read_bytes(), told)
            return read_affect(told.casefold())
        except InputError as error:
            self.wrong("affect", error.code, error.message)
        except OSError as error:
            self.wrong("affect", "file_unreadable", f"{told}: cannot be read: {error.strerror}")
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
        told = self.text(name)
        try:
            return read(told.encode() if told.startswith("{") else (self.folder / told).read_bytes())
        except InputError as error:
            self.wrong(name, error.code, error.message)
        except OSError as error:
            self.wrong(name, "file_unreadable", f"{told}: cannot be read: {error.strerror}")
        return None

    def wrong(self, name: str, code: str, message: str) -> None:
        column = self.columns.name(name) if name in self.columns.places else ""
        self.problems.append(RowProblem(self.number, column, code, message, self.text("id")))

    def _seconds(self, name: str) -> float | None:
        told = self.text(name)
        if not told:
            return None
        match = _CLOCK.fullmatch(told)
        if match is None:
            self.wrong(name, "value_wrong", f"{told!r} is no time; give seconds or h:mm:ss.ms")
            return None
        hours, minutes, seconds = (float((part or "0").replace(",", ".")) for part in match.groups())
        return 3600 * hours + 60 * minutes + seconds
