"""The request for a study, and its lines: from a script in the format of `understudy batch`, or from a folder of
recordings with a text file beside each.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import TYPE_CHECKING

from ...batch.matching import find_recordings
from ...batch.planning import BatchRequest, plan_batch, without_audio
from ...batch.work.jobs import LineJob
from ...errors import InputError
from ...model import Line
from ...options import Options
from ..comparison import Comparison

if TYPE_CHECKING:
    from ...library.motion_models import MotionModel
    from ...profiles.profile import Profile

PAGE_FOLDER = "page"
"""The folder for raters, within the output folder."""


@dataclass(frozen=True, slots=True)
class StudySource:
    """The paths of a study: a script or a folder of lines, the folder of the script's recordings (None: the script's
    folder), and the output folder."""

    lines: Path
    audio: Path | None
    out: Path


@dataclass(frozen=True, slots=True)
class StudyRequest:
    """The request for a study: lines, comparison, and the options of the performances, whose seed is also the seed of
    codes and orders. Comparisons of ways and affect have a motion model, those of speakers their profiles."""

    source: StudySource
    comparison: Comparison
    options: Options
    model: MotionModel | None = None
    speakers: Mapping[str, Profile | str] = field(default_factory=dict)

    @property
    def seed(self) -> int:
        return self.options.seed


@dataclass(frozen=True, slots=True)
class StudyLine:
    """A line of the study: its name, the line, and the options of its performance."""

    id: str
    line: Line
    options: Options


def read_lines(source: StudySource, options: Options) -> tuple[StudyLine, ...]:
    """The lines in order, with `options`; the script may override the options of single lines.

    Raises InputError `study_lines` with every unusable line, and as `plan_batch` does.
    """
    return tuple(_in_folder(source, options) if source.lines.is_dir() else _in_script(source, options))


def _in_folder(source: StudySource, options: Options) -> Iterator[StudyLine]:
    found = find_recordings(source.lines, without=source.out)
    wordless = [each.relative for each in found if not each.path.with_suffix(".txt").is_file()]
    if wordless or not found:
        problem = (
            f"no words for {', '.join(wordless)}; put them beside it in a .txt" if found else "no recordings in it"
        )
        raise InputError("study_lines", f"{source.lines}: {problem}", field="lines")
    for each in found:
        yield StudyLine(each.stem, Line(each.path.read_bytes(), _text(each.path.with_suffix(".txt"))), options)


def _text(path: Path) -> str:
    try:
        return path.read_text(encoding="utf-8-sig")
    except UnicodeDecodeError as error:
        raise InputError("study_lines", f"{path}: not UTF-8 at byte {error.start}; save it as UTF-8") from None


def _in_script(source: StudySource, options: Options) -> Iterator[StudyLine]:
    audio = source.audio or source.lines.parent
    request = BatchRequest(source.lines, audio, source.out, options=options, has_partners=False, learns_voices=False)
    plan = plan_batch(request)
    wrong = [*map(str, plan.script.problems), *map(without_audio, plan.joined.missing)]
    if wrong:
        raise InputError("study_lines", f"{source.lines}: {'; '.join(wrong)}", field="lines")
    for _take, job in plan.jobs:
        yield StudyLine(job.id, _line(job), replace(job.options, listeners=()))


def _line(job: LineJob) -> Line:
    return Line(job.audio.content(), job.text, direction=job.direction)
