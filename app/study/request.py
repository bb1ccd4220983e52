"""The request for a study."""

from dataclasses import dataclass
from pathlib import Path

from ..options import Options
from .comparison import Comparison

PAGE_FOLDER = "page"
"""Under the output folder: what raters get."""


@dataclass(frozen=True, slots=True)
class StudySource:
    """Where lines are read: a script or a folder, the folder of a script's recordings (None: that it lies in), and
    where the study is written."""

    lines: Path
    audio: Path | None
    out: Path


@dataclass(frozen=True, slots=True)
class StudyRequest:
    """What is compared on which lines, how they are performed, and the seed of codes and orders, which is also that of
    the performances."""

    source: StudySource
    comparison: Comparison
    options: Options

    @property
    def seed(self) -> int:
        return self.options.seed
