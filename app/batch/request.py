"""What a batch is asked for."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path

from ..performance import Options
from .layout import Layout
from .matching.joining import Choice
from .matching.patterns import Pattern
from .work.formats import LineFormat, OutputFormat
from .work.jobs import MotionForm


@dataclass(frozen=True, slots=True)
class BatchRequest:
    """A script, where its recordings are (a folder, or one recording that lines are cut out of), where to write, and
    how. `options` are those that all lines have in common, `cast` the file that says who performs whom. `has_partners`
    makes listeners of those who speak next to a line in its scene, `learns_voices` learns how speakers usually sound;
    `again` performs what is done as well; `thumbnails` is how many lines of the report are shown."""

    script: Path
    audio: Path
    out: Path
    formats: tuple[OutputFormat, ...] = (LineFormat.BML,)
    layout: Layout = field(default_factory=Layout)
    columns: Mapping[str, str] = field(default_factory=dict)
    pattern: Pattern | None = None
    choice: Choice = Choice.LAST
    options: Options = field(default_factory=Options)
    motion: MotionForm = field(default_factory=MotionForm)
    cast: Path | None = None
    has_partners: bool = True
    learns_voices: bool = True
    again: bool = False
    thumbnails: int = 0
