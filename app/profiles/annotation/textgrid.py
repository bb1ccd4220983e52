"""Reads Praat's TextGrid in its long or short form. Each interval tier is a track; intervals without a label and point
tiers are ignored.

Like Praat, reads only the quoted texts, the free-standing numbers and `<exists>` of either form; the rest is for human
readers. praatio is not used, because it does not report the location of mistakes.
"""

import re
from collections.abc import Iterator
from math import isfinite
from pathlib import Path

from .model import AnnotationError, AnnotationMistake
from .tracks import Track, TrackSpan, decoded, track_of

_TOKEN = re.compile(r'"(?:[^"]|"")*"|[^\s"]+')
_KINDS = {"IntervalTier": 3, "TextTier": 2}
"""The classes of tiers, and the number of values in each of their entries."""


def read_textgrid(content: bytes, path: Path) -> tuple[Track, ...]:
    """The tiers of a file; raises AnnotationError with every invalid time, and if the file is truncated."""
    reading = _TextGridValues(decoded(content, path), path)
    try:
        tracks = tuple(reading.tracks())
    except _BrokenError as error:
        raise AnnotationError([*reading.mistakes, AnnotationMistake(path, str(error), reading.track)]) from None
    if reading.mistakes:
        raise AnnotationError(reading.mistakes)
    return tracks


class _BrokenError(ValueError):
    """An expected value is missing, so the rest of the file cannot be read."""


class _TextGridValues:
    """The sequence of a file's values; `track` is the current tier."""

    def __init__(self, text: str, path: Path) -> None:
        self._text, self._path = text, path
        self._values = self._found()
        self._line = 1
        self.track = ""
        self.mistakes: list[AnnotationMistake] = []

    def tracks(self) -> Iterator[Track]:
        """The interval tiers in order."""
        if [next(self._values, ""), next(self._values, "")] != ['"ooTextFile"', '"TextGrid"']:
            raise _BrokenError('not a TextGrid: it begins with "ooTextFile" and "TextGrid"')
        self._number(), self._number()
        if self._next() != "<exists>":
            return
        for _tier in range(self._count()):
            kind, self.track = self._quoted(), self._quoted()
            if kind not in _KINDS:
                raise _BrokenError(f"line {self._line}: {kind!r} is not a class of tiers; give {' or '.join(_KINDS)}")
            self._number(), self._number()
            spans = [self._span(_KINDS[kind]) for _entry in range(self._count())]
            if kind == "IntervalTier":
                yield track_of(self.track, (span for span in spans if span is not None and span.label))

    def _span(self, values: int) -> TrackSpan | None:
        """An interval, or a point as an interval without duration; None if a time is invalid."""
        times = [self._number() for _value in range(values - 1)]
        label = self._quoted().strip()
        return None if None in times else TrackSpan(float(times[0] or 0.0), float(times[-1] or 0.0), label)

    def _number(self) -> float | None:
        """A number; None, with a mistake recorded, for anything else."""
        value = self._next()
        number = _number_of(value)
        if number is None and value.startswith('"'):
            raise _BrokenError(f"line {self._line}: a number is expected, and there is {value}")
        if number is None:
            message = f"line {self._line}: {value!r} is not a number"
            self.mistakes.append(AnnotationMistake(self._path, message, self.track))
        return number

    def _count(self) -> int:
        number = self._number()
        if number is None or number != int(number) or number < 0:
            raise _BrokenError(f"line {self._line}: it does not say how many there are")
        return int(number)

    def _quoted(self) -> str:
        value = self._next()
        if not value.startswith('"'):
            raise _BrokenError(f"line {self._line}: a text in quotes is expected, and there is {value[:40]}")
        return value[1:-1].replace('""', '"')

    def _next(self) -> str:
        value = next(self._values, None)
        if value is None:
            raise _BrokenError(f"line {self._line}: the file ends before all that it announces")
        return value

    def _found(self) -> Iterator[str]:
        """The values, and any other text after `=`."""
        before, last = "", 0
        for match in _TOKEN.finditer(self._text):
            token = match[0]
            self._line, last = self._line + self._text.count("\n", last, match.start()), match.start()
            if token[0] == '"' or token == "<exists>" or before == "=" or _number_of(token) is not None:
                yield token
            before = token


def _number_of(token: str) -> float | None:
    try:
        number = float(token)
    except ValueError:
        return None
    return number if isfinite(number) else None
