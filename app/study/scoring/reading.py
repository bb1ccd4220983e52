"""The answers of raters, from the CSV files of the page or of any other form.

A file of ratings has the columns `rater`, `rating` (1 to 10) and `clip`, the name of the clip as the page has it, or
instead of it `line` and `condition`; `choice` (best, worst or empty) may be there. A file of comparisons has `rater`,
`dimension`, `answer` (A, B or undecided) and `a` and `b`, the two clips, or instead of them `line`, and U or S for an
answer. What a clip shows is in the key that `understudy study make` wrote (columns `clip`, `line`, `condition`).
"""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TypeVar

from ..comparison import (
    CONDITIONS,
    DIMENSIONS,
    HIGHEST,
    KEY_COLUMNS,
    KEY_NAME,
    LOWEST,
    MOST_UNDERSTOOD,
    UNDECIDED,
    UNDERSTOOD,
    Comparison,
    Key,
    RaterChoice,
    Shown,
)
from .tables import AnswersError, CellMistake, Table, TableRow, read_table


@dataclass(frozen=True, slots=True)
class Rating:
    """What a rater gave one clip of a line."""

    rater: str
    line: str
    condition: str
    grade: float
    choice: RaterChoice = RaterChoice.NEITHER


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


def read_answers(paths: Sequence[Path], key: Path | None = None) -> Answers:
    """The answers in these files, whose clips are told by `key`, or by the key.csv beside the first file or in the
    folder above.

    Raises AnswersError with every mistake, and as `read_table` does.
    """
    tables = [read_table(path) for path in paths]
    kinds = [_comparison(table) for table in tables]
    if len(set(kinds)) > 1:
        message = f"answers about {kinds[-1]}, and those of {paths[0]} are about {kinds[0]}; score them apart"
        raise AnswersError([CellMistake(paths[-1], 1, message)])
    reading = _Reading(kinds[0], _key(paths, key))
    for table in tables:
        reading.read(table)
    return reading.answers()


def read_key(path: Path) -> Key:
    """The clips of a study; raises as `read_answers` does."""
    table = read_table(path)
    table.require(KEY_COLUMNS)
    known = {condition for conditions in CONDITIONS.values() for condition in conditions}
    wrong = [row for row in table.rows if row.cells["condition"] not in known]
    if wrong:
        raise AnswersError(row.refused("condition", f"give one of {', '.join(sorted(known))}") for row in wrong)
    return {row.cells["clip"]: Shown(row.cells["line"], row.cells["condition"]) for row in table.rows}


def _comparison(table: Table) -> Comparison:
    """The comparison that a file's columns belong to; raises AnswersError if they fit neither."""
    if "dimension" in table.columns:
        table.require(("rater", "dimension", "answer"))
        return Comparison.UNITS
    table.require(("rater", "rating"))
    return Comparison.MODES


def _key(paths: Sequence[Path], named: Path | None) -> Key | None:
    if named is not None:
        return read_key(named)
    beside = (folder / KEY_NAME for folder in (paths[0].resolve().parent, paths[0].resolve().parent.parent))
    return next((read_key(path) for path in beside if path.is_file()), None)


class _Reading:
    """Reads several tables and collects their mistakes."""

    def __init__(self, comparison: Comparison, key: Key | None) -> None:
        self._comparison, self._key = comparison, key
        self._mistakes: list[CellMistake] = []
        self._ratings: list[Rating] = []
        self._verdicts: list[Verdict] = []
        self._understood: list[int] = []
        self._first: dict[tuple[str, ...], TableRow] = {}

    def read(self, table: Table) -> None:
        """Reads every row; raises AnswersError where the columns do not say what clips show."""
        clips = ("clip",) if self._comparison is Comparison.MODES else ("a", "b")
        named = ("line", "condition") if self._comparison is Comparison.MODES else ("line",)
        if self._key is None and any(name in table.columns for name in clips):
            message = f"clips by name, and no {KEY_NAME} near to tell what they show; give --key the one of study make"
            raise AnswersError([CellMistake(table.path, 1, message)])
        table.require(clips if self._key is not None and clips[0] in table.columns else named)
        read_row = self._rating if self._comparison is Comparison.MODES else self._verdict
        for row in table.rows:
            if not row.cells["rater"]:
                self._mistakes.append(row.wrong("rater", "empty; every answer is somebody's"))
            read_row(row)

    def answers(self) -> Answers:
        """The answers; raises AnswersError with every mistake."""
        if self._mistakes:
            raise AnswersError(self._mistakes)
        return Answers(self._comparison, tuple(self._ratings), tuple(self._verdicts), tuple(self._understood))

    def _rating(self, row: TableRow) -> None:
        clip = self._clip(row, "clip") if "clip" in row.cells else self._told(row)
        grade, choice = self._grade(row), self._choice(row)
        if clip is None or grade is None or choice is None:
            return
        if self._is_new(row, row.cells["rater"], clip.line, clip.condition):
            self._ratings.append(Rating(row.cells["rater"], clip.line, clip.condition, grade, choice))

    def _told(self, row: TableRow) -> Shown | None:
        condition, known = row.cells["condition"], CONDITIONS[Comparison.MODES]
        if condition not in known:
            self._mistakes.append(row.refused("condition", f"give one of {', '.join(known)}"))
            return None
        return Shown(row.cells["line"], condition)

    def _clip(self, row: TableRow, name: str) -> Shown | None:
        shown = (self._key or {}).get(row.cells[name])
        if shown is None or shown.condition not in CONDITIONS[self._comparison]:
            self._mistakes.append(row.refused(name, "the key has no such clip; is it that of another study?"))
            return None
        return shown

    def _grade(self, row: TableRow) -> float | None:
        try:
            grade = float(row.cells["rating"])
        except ValueError:
            grade = LOWEST - 1
        if LOWEST <= grade <= HIGHEST:
            return grade
        self._mistakes.append(row.refused("rating", f"give a number from {LOWEST} to {HIGHEST}"))
        return None

    def _choice(self, row: TableRow) -> RaterChoice | None:
        told = row.cells.get("choice", "")
        if told in set(RaterChoice):
            return RaterChoice(told)
        self._mistakes.append(row.refused("choice", "give best, worst or nothing"))
        return None

    def _verdict(self, row: TableRow) -> None:
        dimension = row.cells["dimension"]
        if dimension == UNDERSTOOD:
            self._understanding(row)
        elif dimension not in DIMENSIONS:
            self._mistakes.append(row.refused("dimension", f"give one of {', '.join((*DIMENSIONS, UNDERSTOOD))}"))
        else:
            self._decision(row, dimension)

    def _understanding(self, row: TableRow) -> None:
        answer = row.cells["answer"]
        if answer in map(str, range(1, MOST_UNDERSTOOD + 1)):
            self._understood.append(int(answer))
        else:
            self._mistakes.append(row.refused("answer", f"give 1 to {MOST_UNDERSTOOD} for {UNDERSTOOD}"))

    def _decision(self, row: TableRow, dimension: str) -> None:
        if "a" in row.cells:
            clips = [self._clip(row, name) for name in ("a", "b")]
            if None in clips:
                return
            choices = {label: clip.condition for label, clip in zip("AB", clips, strict=True) if clip}
            line = next(clip.line for clip in clips if clip)
        else:
            choices, line = {each: each for each in CONDITIONS[Comparison.UNITS]}, row.cells["line"]
        answer = row.cells["answer"]
        if answer != UNDECIDED and answer not in choices:
            self._mistakes.append(row.refused("answer", f"give {', '.join(choices)} or {UNDECIDED}"))
        elif self._is_new(row, row.cells["rater"], line, dimension):
            self._verdicts.append(Verdict(row.cells["rater"], line, dimension, choices.get(answer)))

    def _is_new(self, row: TableRow, *answered: str) -> bool:
        """Whether nobody has answered this before; the same answer twice is a mistake."""
        first = self._first.setdefault(answered, row)
        if first is not row:
            message = f"{' '.join(answered[1:])}: this rater has answered it already, at {first.path}:{first.line}"
            self._mistakes.append(row.wrong("rater", message))
        return first is row


Answer = TypeVar("Answer", Rating, Verdict)


def by_rater(answers: Iterable[Answer]) -> dict[str, list[Answer]]:
    """The answers of each rater, in the order of their first."""
    found: dict[str, list[Answer]] = {}
    for each in answers:
        found.setdefault(each.rater, []).append(each)
    return found
