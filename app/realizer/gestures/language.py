"""Parses gesture files (Gesture Engine §4.2) into statements (`statements.py`), collecting every mistake.

The language has one statement per line. Each line is parsed separately, then lines are assembled: GESTURECLASS begins a
gesture, STARTFRAME … ENDFRAME enclose a frame. `definitions.py` interprets the words.
"""

import re
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace
from functools import cache, lru_cache
from pathlib import Path
from types import MappingProxyType

from lark import Lark, Token, Tree, UnexpectedInput, UnexpectedToken

from ...errors import Mistake, nearest_names
from ...files import read_source
from .statements import (
    OTHER,
    FrameTree,
    GestureFile,
    GestureTree,
    LocatedMistake,
    Statement,
    StatementValue,
    mistake_in,
)

HEADER: Mapping[str, str] = MappingProxyType(
    {
        "GESTURECLASS": "GESTURECLASS iconic",
        "GESTUREINSTANCE": "GESTUREINSTANCE small",
        "DURATION": "DURATION 1.5",
        "ARMS": "ARMS both",
        "CATEGORY": "CATEGORY SMALL PINCH",
        "AIMED": "AIMED",
        "LEVELS": "LEVELS medium high",
        "EXPRESSIVITY": "EXPRESSIVITY low amplitude 0.8 tempo 0.9",
        "TRACK": "TRACK held chest 0 12 0",
    }
)
"""The statements before the frames, each with an example."""

FRAME: Mapping[str, str] = MappingProxyType(
    {
        "STARTFRAME": "STARTFRAME 0.4",
        "FRAMETYPE": "FRAMETYPE stroke_end",
        "ARM": "ARM XC YUpperP ZNear, or with OFFSET 0.02 0 -0.05 behind",
        "HAND": "HAND symbol_1_open",
        "FINGER": "FINGER index bend_curved",
        "WRIST": "WRIST FBUp PalmInwards",
        "SHOULDER": "SHOULDER 0.5",
        "JOINT": "JOINT LowerArm 0 -80 0",
        "TENSION": "TENSION 0.5",
        "CONTINUITY": "CONTINUITY -0.5",
        "BIAS": "BIAS 0.3",
        "ADDNOISE": "ADDNOISE",
        "ENDFRAME": "ENDFRAME",
    }
)
"""The statements of frames, each with an example."""

OF_AN_ARM = frozenset({"ARM", "HAND", "FINGER", "WRIST", "SHOULDER", "JOINT"})
"""The statements that may follow OTHER."""


def read_gestures(path: Path) -> tuple[GestureFile, tuple[Mistake, ...]]:
    """The parsed file at `path`, as far as it is readable, and its syntax mistakes."""
    text = read_source(path)
    if isinstance(text, Mistake):
        return GestureFile(path), (text,)
    return parse_gestures(text, path)


def parse_gestures(text: str, path: Path) -> tuple[GestureFile, tuple[Mistake, ...]]:
    """As `read_gestures`, for text in memory; `path` is for messages."""
    lines = tuple(line.expandtabs(1) for line in text.split("\n"))
    wrong: list[LocatedMistake] = []
    gestures = _Assembly(wrong).of(_statements(lines, wrong))
    file = GestureFile(path, lines, gestures)
    return file, tuple(mistake_in(file, found) for found in wrong)


@cache
def _grammar() -> Lark:
    return Lark.open("gesture.lark", rel_to=__file__, parser="lalr")


@lru_cache(maxsize=2048)
def _parsed(code: str) -> Tree[Token]:
    """Cached, since gestures repeat lines: only one in six of a library is new."""
    return _grammar().parse(code)


def _statements(lines: tuple[str, ...], wrong: list[LocatedMistake]) -> Iterator[Statement]:
    """The statement of each non-empty line; an unreadable one counts as what it most likely is."""
    for number, line in enumerate(lines, start=1):
        code = line.split("#", maxsplit=1)[0].rstrip()
        if not code.strip():
            continue
        try:
            yield _statement(_parsed(code), number)
        except UnexpectedInput as error:
            yield _unread(_words(code, number), _column(error, code), wrong)


def _statement(tree: Tree[Token], line: int) -> Statement:
    *other, stated = (child for child in tree.children if child is not None)
    assert isinstance(stated, Tree)
    keyword, *values = (
        StatementValue(str(token), line, token.column or 1) for token in stated.children if isinstance(token, Token)
    )
    words = tuple(value for value in values if value.text[0].isalpha())
    numbers = tuple(value for value in values if not value.text[0].isalpha())
    return Statement(keyword, words, numbers, other=bool(other))


def _words(code: str, line: int) -> list[StatementValue]:
    """The words of an unreadable line; an empty word marks its end."""
    words = [StatementValue(found.group(), line, found.start() + 1) for found in re.finditer(r"\S+", code)]
    return [*words, StatementValue("", line, len(code) + 1)]


def _column(error: UnexpectedInput, code: str) -> int:
    at_end = isinstance(error, UnexpectedToken) and error.token.type == "$END"
    return len(code) + 1 if at_end else int(error.column)


def _unread(words: list[StatementValue], column: int, wrong: list[LocatedMistake]) -> Statement:
    """The probable statement of a line that is unreadable from `column` on; its mistake is appended to `wrong`."""
    other = words[0].text == OTHER and len(words) > 2
    keyword = words[1] if other else words[0]
    known = {**HEADER, **FRAME}
    guessed = keyword.text if keyword.text in known else _nearest(keyword.text, known)
    if keyword.text not in known:
        meant = f"did you mean {guessed}?" if guessed else f"lines of a gesture file begin with {', '.join(known)}"
        wrong.append(LocatedMistake(keyword, f"no line begins with {keyword.text!r}; {meant}"))
    elif other and keyword.text not in OF_AN_ARM:
        told = f"OTHER sets the other arm's {', '.join(sorted(OF_AN_ARM))}, not {keyword.text}"
        wrong.append(LocatedMistake(keyword, told))
    else:
        at = next(word for word in words if word.column + len(word.text) > column or not word.text)
        found = f"found {at.text!r}" if at.text else "the line ends too soon"
        told = f"{found}; {keyword.text} is written as in: {known[keyword.text]}"
        wrong.append(LocatedMistake(replace(at, column=max(at.column, column)), told))
    return Statement(replace(keyword, text=guessed or ""), other=other, readable=False)


def _nearest(word: str, known: Iterable[str]) -> str | None:
    return next(iter(nearest_names(word.upper(), known)), None)


class _Assembly:
    """Assembles statements into gestures; misplaced ones are appended to `wrong`."""

    def __init__(self, wrong: list[LocatedMistake]) -> None:
        self._wrong = wrong
        self._gestures: list[GestureTree] = []
        self._header: list[Statement] = []
        self._frames: list[FrameTree] = []
        self._start: Statement | None = None
        self._inside: list[Statement] = []

    def of(self, statements: Iterator[Statement]) -> tuple[GestureTree, ...]:
        for statement in statements:
            keyword = statement.keyword.text
            if keyword == "GESTURECLASS":
                self._end_gesture()
                self._header = [statement]
                continue
            if not self._header:
                self._say(statement, "a gesture begins with GESTURECLASS")
                self._header = [replace(statement, keyword=replace(statement.keyword, text=""), readable=False)]
            if keyword == "STARTFRAME":
                self._end_frame(closed=False)
                self._start = statement
            elif keyword == "ENDFRAME" and self._start is None:
                self._say(statement, "ENDFRAME without a STARTFRAME before it")
            elif keyword == "ENDFRAME":
                self._end_frame(closed=True)
            else:
                self._take(statement)
        self._end_gesture()
        return tuple(self._gestures)

    def _take(self, statement: Statement) -> None:
        keyword = statement.keyword.text
        if self._start is not None and keyword not in HEADER:
            self._inside.append(statement)
        elif self._start is not None:
            self._say(statement, f"{keyword} belongs before the first frame; or is an ENDFRAME missing above?")
        elif keyword in FRAME:
            self._say(statement, f"{keyword} belongs in a frame, between STARTFRAME and ENDFRAME")
        elif self._frames:
            self._say(statement, f"{keyword} belongs before the first frame")
        else:
            self._header.append(statement)

    def _end_frame(self, *, closed: bool) -> None:
        if self._start is not None:
            if not closed:
                self._say(self._start, "this frame has no ENDFRAME")
            self._frames.append(FrameTree(self._start, tuple(self._inside)))
        self._start, self._inside = None, []

    def _end_gesture(self) -> None:
        self._end_frame(closed=False)
        if self._header:
            self._gestures.append(GestureTree(tuple(self._header), tuple(self._frames)))
        self._header, self._frames = [], []

    def _say(self, statement: Statement, message: str) -> None:
        """Report a mistake, but only on readable lines: the others have been reported already."""
        if statement.readable:
            self._wrong.append(LocatedMistake(statement.keyword, message))
