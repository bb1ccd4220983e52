"""The syntax tree of gesture files: statements, frames and gestures.

Lines and columns count from 1. An unreadable line is a statement without words and with `readable` false, so that the
lines around it can still be interpreted.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from ...errors import Mistake

OTHER = "OTHER"
"""The keyword before a statement that speaks of the other arm."""


@dataclass(frozen=True, slots=True)
class StatementValue:
    """A value of a statement and its position."""

    text: str
    line: int
    column: int


@dataclass(frozen=True, slots=True)
class Statement:
    """One line: keyword, arguments, and whether it refers to the other arm. `numbers` are the numeric arguments in
    order, guaranteed numeric by the grammar."""

    keyword: StatementValue
    words: tuple[StatementValue, ...] = ()
    numbers: tuple[StatementValue, ...] = ()
    other: bool = False
    readable: bool = True


@dataclass(frozen=True, slots=True)
class FrameTree:
    """The lines from STARTFRAME to ENDFRAME, without the latter."""

    start: Statement
    statements: tuple[Statement, ...]


@dataclass(frozen=True, slots=True)
class GestureTree:
    """A gesture: the header lines, beginning with GESTURECLASS, and the frames."""

    header: tuple[Statement, ...]
    frames: tuple[FrameTree, ...]

    @property
    def start(self) -> StatementValue:
        return self.header[0].keyword

    def all_readable(self) -> bool:
        """Whether all its lines were readable."""
        return all(statement.readable for statement in self._statements())

    def _statements(self) -> Iterator[Statement]:
        yield from self.header
        for frame in self.frames:
            yield from (frame.start, *frame.statements)


@dataclass(frozen=True, slots=True)
class GestureFile:
    """A parsed file: its lines and gestures."""

    path: Path
    lines: tuple[str, ...] = ()
    gestures: tuple[GestureTree, ...] = ()


@dataclass(frozen=True, slots=True)
class LocatedMistake:
    """A mistake and the word at which it was found."""

    at: StatementValue
    message: str


def mistake_in(file: GestureFile, found: LocatedMistake) -> Mistake:
    """A located mistake with its file and source line."""
    at = found.at
    return Mistake(file.path, at.line, at.column, found.message, file.lines[at.line - 1].rstrip("\r"))
