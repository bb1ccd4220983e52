"""The request for a study."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING

from ..options import Options
from .comparison import Comparison

if TYPE_CHECKING:
    from ..library.motion_models import MotionModel
    from ..profiles.profile import Profile

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
    the performances; the motion model of ways and affect, and the profiles of speakers."""

    source: StudySource
    comparison: Comparison
    options: Options
    model: MotionModel | None = None
    speakers: Mapping[str, Profile | str] = field(default_factory=dict)

    @property
    def seed(self) -> int:
        return self.options.seed
