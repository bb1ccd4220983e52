"""What a caller may give: a file by name or by content, a level or a tone by value or by name."""

import os
from collections.abc import Sequence
from pathlib import Path
from typing import Literal

from ..errors import InputError
from ..model import GivenFunction, Level, Line, Timings, Tone
from ..schemas.requests import read_timings

FileSource = bytes | str | os.PathLike[str]
"""A file: its content, or its name."""

LevelName = Level | Literal["low", "medium", "high"]
AffectName = Tone | Literal["neutral", "happy", "sad", "angry", "afraid", "disgusted", "surprised"]


def line_of(
    audio: FileSource,
    text: str,
    words: FileSource | Timings | None = None,
    functions: Sequence[GivenFunction] = (),
) -> Line:
    """The line of a recording and its words; raises InputError `timings_format`."""
    return Line(content_of(audio), text, timings_of(words), tuple(functions))


def content_of(source: FileSource) -> bytes:
    """The content of a file; raises OSError."""
    return source if isinstance(source, bytes) else Path(source).read_bytes()


def timings_of(words: FileSource | Timings | None) -> Timings | None:
    """Words timed elsewhere; raises InputError `timings_format`."""
    if words is None or isinstance(words, Timings):
        return words
    if isinstance(words, bytes):
        message = "words: bytes do not tell their format; give the name of a file, or Timings(content, format)"
        raise InputError("timings_format", message, field="words")
    return read_timings(os.fspath(words), content_of(words))
