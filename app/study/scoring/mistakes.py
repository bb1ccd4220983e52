"""The mistakes in files of answers: all files are checked at once, each mistake with its line and column."""

from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

from ...errors import InputError

MOST_TOLD = 20


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


class AnswersError(InputError):
    """Files of answers that do not hold together: `mistakes` has every one, the message the first twenty."""

    def __init__(self, mistakes: Iterable[CellMistake]) -> None:
        self.mistakes = tuple(mistakes)
        told = list(map(str, self.mistakes[:MOST_TOLD]))
        more = len(self.mistakes) - len(told)
        super().__init__("answers_wrong", "\n".join([*told, *([f"and {more} more"] if more else [])]), field="answers")
