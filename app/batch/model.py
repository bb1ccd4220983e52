"""The values of a batch.

Rows count as in a spreadsheet: from 1, a header included; in a screenplay a row is a line of the file, in subtitles a
cue. Times are seconds from the start of the recording.
"""

from dataclasses import dataclass
from pathlib import Path

from ..model import AffectTrack, Direction, Interval, Level, Target
from ..model.edits import Edits


@dataclass(frozen=True, slots=True)
class ScriptLine:
    """A line of a script.

    `character` is the cue name as in the script, `comment` is a remark on the delivery ("whispers"), for people;
    `sheet` is the worksheet if lines of several are read;
    `recording` is the file named in the script, `interval` the place of the line in a longer recording. `listeners` are
    those the script names; None leaves it to cast and scene. `edits` are those the script names.
    """

    row: int
    id: str
    text: str
    character: str = ""
    recording: str = ""
    comment: str = ""
    scene: str = ""
    take: int | None = None
    interval: Interval | None = None
    direction: Direction | None = None
    edits: Edits | None = None
    listeners: tuple[str, ...] | None = None
    agitation: Level | None = None
    affect: AffectTrack | None = None
    seed: int | None = None
    targets: tuple[Target, ...] = ()
    sheet: str = ""


@dataclass(frozen=True, slots=True)
class RowProblem:
    """Why a row is not a line that can be performed. `code` is stable; `column` is as people find it ("C (text)"),
    empty if it concerns the whole row; `id` is the line's, if known. `unit` is what rows are called in the script."""

    row: int
    column: str
    code: str
    message: str
    id: str = ""
    sheet: str = ""
    unit: str = "row"

    def __str__(self) -> str:
        column = f", column {self.column}" if self.column else ""
        return f"{place_told(self.row, self.sheet, self.unit)}{column}: {self.message}"


def place_told(row: int, sheet: str = "", unit: str = "row") -> str:
    """A place in a script in words: "row 7", "sheet 'Act 2', row 7", "line 7"."""
    return f"sheet {sheet!r}, {unit} {row}" if sheet else f"{unit} {row}"


@dataclass(frozen=True, slots=True)
class Script:
    """A script as read: the usable lines, problems with the others, and remarks about what was guessed or left out.
    `columns` are the headings by field, and those of no field, of a sheet; `unit` is what its rows are called."""

    path: Path
    lines: tuple[ScriptLine, ...]
    problems: tuple[RowProblem, ...] = ()
    remarks: tuple[str, ...] = ()
    columns: tuple[tuple[str, str], ...] = ()
    unit: str = "row"


@dataclass(frozen=True, slots=True)
class Recording:
    """A file of speech and the interval of the line in it; None is the whole file."""

    path: Path
    interval: Interval | None = None


@dataclass(frozen=True, slots=True)
class Take:
    """A line with one recording of it; `id` names it in the manifest and in the names of files."""

    id: str
    line: ScriptLine
    recording: Recording
    number: int | None = None
