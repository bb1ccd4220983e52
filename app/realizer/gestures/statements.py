"""What a gesture file says, line by line, before its words are understood: statements, frames and gestures.

Lines and columns count from 1. A line that could not be read is a statement without words that is not `sound`: it
holds its place, so that what stands around it is still understood.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path


@dataclass(frozen=True, slots=True)
class Word:
    """A value of a statement."""

    text: str
    line: int
    column: int


@dataclass(frozen=True, slots=True)
class Statement:
    """One line: its keyword, what follows it, and whether it speaks of the other arm. `numbers` are words as well, in
    the order in which they stand; the grammar sees to it that they are numbers."""

    keyword: Word
    words: tuple[Word, ...] = ()
    numbers: tuple[Word, ...] = ()
    other: bool = False
    sound: bool = True


@dataclass(frozen=True, slots=True)
class FrameTree:
    """The lines from STARTFRAME to ENDFRAME, both left out."""

    start: Statement
    statements: tuple[Statement, ...]


@dataclass(frozen=True, slots=True)
class GestureTree:
    """A gesture as written: the lines before its frames, the first being GESTURECLASS, and its frames."""

    header: tuple[Statement, ...]
    frames: tuple[FrameTree, ...]

    @property
    def start(self) -> Word:
        return self.header[0].keyword

    def all_sound(self) -> bool:
        """Whether each of its lines could be read."""
        return all(statement.sound for statement in self._statements())

    def _statements(self) -> Iterator[Statement]:
        yield from self.header
        for frame in self.frames:
            yield from (frame.start, *frame.statements)


@dataclass(frozen=True, slots=True)
class GestureFile:
    """A file as read: its lines, and the gestures in them."""

    path: Path
    lines: tuple[str, ...] = ()
    gestures: tuple[GestureTree, ...] = ()


@dataclass(frozen=True, slots=True)
class Located:
    """A mistake, at the word where it shows."""

    at: Word
    message: str
