"""The answers of raters, whatever file they came in."""

from collections.abc import Iterable
from dataclasses import dataclass
from typing import TypeVar

from ..comparison import Choice, Comparison


@dataclass(frozen=True, slots=True)
class Rating:
    """What a rater gave one clip of a line."""

    rater: str
    line: str
    condition: str
    grade: float
    choice: Choice = Choice.NEITHER


@dataclass(frozen=True, slots=True)
class Verdict:
    """In which condition a line's character is more of a dimension; None is undecided."""

    rater: str
    line: str
    dimension: str
    chosen: str | None


@dataclass(frozen=True, slots=True)
class Answers:
    """The answers of all files, of one comparison; `understood` is how much was understood, answer by answer."""

    comparison: Comparison
    ratings: tuple[Rating, ...] = ()
    verdicts: tuple[Verdict, ...] = ()
    understood: tuple[int, ...] = ()


Answer = TypeVar("Answer", Rating, Verdict)


def by_rater(answers: Iterable[Answer]) -> dict[str, list[Answer]]:
    """The answers of each rater, in the order of their first."""
    found: dict[str, list[Answer]] = {}
    for each in answers:
        found.setdefault(each.rater, []).append(each)
    return found
