"""Reads raters' answers from the CSV files of the page, or of any other form.

The columns of a file, all with `rater` and optionally `group`, the rater's group:

- ratings: `rating` (1 to 10); `clip`, the clip's name on the page, or `line` and `condition`; optionally `choice`
  (best, worst or empty).
- comparisons: `dimension`; `answer` (A, B or undecided) and the clips `a` and `b`, or `answer` (U, S or undecided) and
  `line`.
- preferences: `preference` (from -2, the first is much better, to 2); the clips `a` and `b`, or `line`, `first` and
  `second`.
- speakers: `answer` (a speaker); `clip`, or `line` and `speaker`; `beside`, the clip shown with it, or empty.

The line and the condition of a clip are in the key that `understudy study make` wrote (columns `clip`, `line`,
`condition`).
"""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from math import nan
from pathlib import Path
from typing import TypeVar

from ..comparison import (
    AFFECT,
    CONDITIONS,
    DIMENSIONS,
    HIGHEST,
    KEY_COLUMNS,
    KEY_NAME,
    LOWEST,
    MOST_UNDERSTOOD,
    MUCH,
    PAIRED,
    PROSODY,
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
    """A rater's grade for one clip of a line."""

    rater: str
    line: str
    condition: str
    grade: float
    choice: RaterChoice = RaterChoice.NEITHER


@dataclass(frozen=True, slots=True)
class Verdict:
    """A rater's choice of the condition in which a line's character is more natural, friendly, …; None is undecided."""

    rater: str
    line: str
    dimension: str
    chosen: str | None


@dataclass(frozen=True, slots=True)
class Understanding:
    """How much of a line's speech a rater understood, from 1 to `MOST_UNDERSTOOD`."""

    rater: str
    line: str
    level: int


@dataclass(frozen=True, slots=True)
class PreferenceAnswer:
    """How much better a rater found the second of two clips of a line, from -`MUCH` to `MUCH`."""

    rater: str
    line: str
    first: str
    second: str
    preference: float


@dataclass(frozen=True, slots=True)
class RecognitionAnswer:
    """A rater's answer to whose gestures a clip shows, seen alone or `beside` another speaker's."""

    rater: str
    line: str
    speaker: str
    answer: str
    beside: bool

    @property
    def is_right(self) -> bool:
        return self.answer == self.speaker


@dataclass(frozen=True, slots=True)
class Answers:
    """The answers in all files, which belong to one comparison, and the groups of the raters that have one."""

    comparison: Comparison
    ratings: tuple[Rating, ...] = ()
    verdicts: tuple[Verdict, ...] = ()
    understood: tuple[Understanding, ...] = ()
    preferred: tuple[PreferenceAnswer, ...] = ()
    named: tuple[RecognitionAnswer, ...] = ()
    groups: Mapping[str, str] = field(default_factory=dict)


def read_answers(paths: Sequence[Path], key: Path | None = None) -> Answers:
    """The answers in these files. Clips are identified by `key`, by default the key.csv in the folder of the first file
    or in its parent.

    Raises AnswersError with every mistake, and as `read_table` does.
    """
    tables = [read_table(path) for path in paths]
    told = _key(paths, key)
    kinds = [_comparison(table, told) for table in tables]
    if len(set(kinds)) > 1:
        message = f"answers about {kinds[-1]}, and those of {paths[0]} are about {kinds[0]}; score them separately"
        raise AnswersError([CellMistake(paths[-1], 1, message)])
    reading = _TableReading(kinds[0], told)
    for table in tables:
        reading.read(table)
    return reading.answers()


def read_key(path: Path) -> Key:
    """The clips of a study; raises as `read_answers` does."""
    table = read_table(path)
    table.require(KEY_COLUMNS)
    known = {condition for conditions in CONDITIONS.values() for condition in conditions}
    wrong = [row for row in table.rows if row.cells["condition"] not in known]
    if 0 < len(wrong) < len(table.rows):  # speakers may have any names, so all are unknown
        raise AnswersError(row.refused("condition", f"give one of {', '.join(sorted(known))}") for row in wrong)
    return {row.cells["clip"]: Shown(row.cells["line"], row.cells["condition"]) for row in table.rows}


def _comparison(table: Table, key: Key | None) -> Comparison:
    """The comparison that a file's columns belong to; raises AnswersError if they fit none."""
    if "dimension" in table.columns:
        table.require(("rater", "dimension", "answer"))
        return Comparison.UNITS
    if "preference" in table.columns:
        table.require(("rater", "preference"))
        told = {row.cells.get(name) for row in table.rows for name in ("first", "second")}
        shown = {each.condition for each in (key or {}).values()} if "a" in table.columns else told
        return Comparison.AFFECT if shown & {AFFECT, PROSODY} else Comparison.WAYS
    if "answer" in table.columns:
        table.require(("rater", "answer"))
        return Comparison.SPEAKERS
    table.require(("rater", "rating"))
    return Comparison.MODES


_CLIPS = {Comparison.MODES: ("clip",), Comparison.SPEAKERS: ("clip",)}
_NAMED = {
    Comparison.MODES: ("line", "condition"),
    Comparison.UNITS: ("line",),
    Comparison.SPEAKERS: ("line", "speaker"),
}
"""The columns that identify the clips, by clip name and by condition; for pairs they are those below."""
_TWO_CLIPS, _TWO_NAMES = ("a", "b"), ("line", "first", "second")


def _key(paths: Sequence[Path], named: Path | None) -> Key | None:
    if named is not None:
        return read_key(named)
    beside = (folder / KEY_NAME for folder in (paths[0].resolve().parent, paths[0].resolve().parent.parent))
    return next((read_key(path) for path in beside if path.is_file()), None)


class _TableReading:
    """Reads several tables and collects their mistakes."""

    def __init__(self, comparison: Comparison, key: Key | None) -> None:
        self._comparison, self._key = comparison, key
        self._mistakes: list[CellMistake] = []
        self._ratings: list[Rating] = []
        self._verdicts: list[Verdict] = []
        self._understood: list[Understanding] = []
        self._preferred: list[PreferenceAnswer] = []
        self._named: list[RecognitionAnswer] = []
        self._groups: dict[str, str] = {}
        self._first: dict[tuple[str, ...], TableRow] = {}

    def read(self, table: Table) -> None:
        """Reads every row; raises AnswersError if the columns do not identify the clips."""
        clips, named = _CLIPS.get(self._comparison, _TWO_CLIPS), _NAMED.get(self._comparison, _TWO_NAMES)
        if self._key is None and any(name in table.columns for name in clips):
            message = (
                f"no {KEY_NAME} was found that says what the named clips show; give the one of study make as --key"
            )
            raise AnswersError([CellMistake(table.path, 1, message)])
        table.require(clips if self._key is not None and clips[0] in table.columns else named)
        paired = dict.fromkeys(PAIRED, self._preference)
        one_of = {Comparison.MODES: self._rating, Comparison.UNITS: self._verdict, Comparison.SPEAKERS: self._naming}
        for row in table.rows:
            self._rater(row)
            (one_of | paired)[self._comparison](row)

    def _rater(self, row: TableRow) -> None:
        rater, group = row.cells["rater"], row.cells.get("group", "")
        if not rater:
            self._mistakes.append(row.wrong("rater", "empty; every answer needs a rater"))
        elif group and self._groups.setdefault(rater, group) != group:
            self._mistakes.append(row.refused("group", f"rater {rater} is of group {self._groups[rater]} elsewhere"))

    def answers(self) -> Answers:
        """The answers; raises AnswersError with every mistake."""
        if self._mistakes:
            raise AnswersError(self._mistakes)
        return Answers(
            self._comparison,
            tuple(self._ratings),
            tuple(self._verdicts),
            tuple(self._understood),
            tuple(self._preferred),
            tuple(self._named),
            dict(self._groups),
        )

    def _rating(self, row: TableRow) -> None:
        clip = self._clip(row, "clip") if "clip" in row.cells else self._condition(row)
        grade, choice = self._number(row, "rating", LOWEST, HIGHEST), self._choice(row)
        if clip is None or grade is None or choice is None:
            return
        if self._is_new(row, row.cells["rater"], clip.line, clip.condition):
            self._ratings.append(Rating(row.cells["rater"], clip.line, clip.condition, grade, choice))

    def _condition(self, row: TableRow, name: str = "condition") -> Shown | None:
        condition, known = row.cells[name], CONDITIONS[self._comparison]
        if condition not in known:
            self._mistakes.append(row.refused(name, f"give one of {', '.join(known)}"))
            return None
        return Shown(row.cells["line"], condition)

    def _clip(self, row: TableRow, name: str) -> Shown | None:
        shown = (self._key or {}).get(row.cells[name])
        known = CONDITIONS[self._comparison]
        if shown is None or (known and shown.condition not in known):
            self._mistakes.append(row.refused(name, "the key has no such clip; is it that of another study?"))
            return None
        return shown

    def _number(self, row: TableRow, name: str, lowest: float, highest: float) -> float | None:
        try:
            number = float(row.cells[name])
        except ValueError:
            number = nan
        if lowest <= number <= highest:
            return number
        self._mistakes.append(row.refused(name, f"give a number from {lowest} to {highest}"))
        return None

    def _choice(self, row: TableRow) -> RaterChoice | None:
        choice = row.cells.get("choice", "")
        if choice in set(RaterChoice):
            return RaterChoice(choice)
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
            clip = self._clip(row, "a") if "a" in row.cells else Shown(row.cells["line"], "")
            if clip is not None and self._is_new(row, row.cells["rater"], clip.line, UNDERSTOOD):
                self._understood.append(Understanding(row.cells["rater"], clip.line, int(answer)))
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

    def _preference(self, row: TableRow) -> None:
        if "a" in row.cells:
            first, second = self._clip(row, "a"), self._clip(row, "b")
        else:
            first, second = self._condition(row, "first"), self._condition(row, "second")
        preference = self._number(row, "preference", -MUCH, MUCH)
        if first is None or second is None or preference is None:
            return
        pair = sorted((first.condition, second.condition))
        if self._is_new(row, row.cells["rater"], first.line, *pair, row.cells.get("trial", "")):
            answer = PreferenceAnswer(row.cells["rater"], first.line, first.condition, second.condition, preference)
            self._preferred.append(answer)

    def _naming(self, row: TableRow) -> None:
        by_clip = "clip" in row.cells
        shown = self._clip(row, "clip") if by_clip else Shown(row.cells["line"], row.cells["speaker"])
        beside, answer = bool(row.cells.get("beside")), row.cells["answer"]
        speakers = {each.condition for each in (self._key or {}).values()} if by_clip else {answer}
        if not answer or answer not in speakers:
            self._mistakes.append(row.refused("answer", f"give a speaker: {', '.join(sorted(speakers)) or 'by name'}"))
        elif shown is not None and self._is_new(row, row.cells["rater"], shown.line, shown.condition, str(beside)):
            self._named.append(RecognitionAnswer(row.cells["rater"], shown.line, shown.condition, answer, beside))

    def _is_new(self, row: TableRow, *answered: str) -> bool:
        """Whether this rater has not answered this before; a repeated answer is a mistake."""
        first = self._first.setdefault(answered, row)
        if first is not row:
            asked = " ".join(filter(None, answered[1:]))
            message = f"{asked}: this rater has answered it already, at {first.path}:{first.line}"
            self._mistakes.append(row.wrong("rater", message))
        return first is row


Answer = TypeVar("Answer", Rating, Verdict, PreferenceAnswer, RecognitionAnswer)


def by_rater(answers: Iterable[Answer]) -> dict[str, list[Answer]]:
    """The answers by rater, in order of each rater's first answer."""
    found: dict[str, list[Answer]] = {}
    for each in answers:
        found.setdefault(each.rater, []).append(each)
    return found
