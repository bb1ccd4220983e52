"""The request for a batch."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path

from ..options import Options
from .layout import Layout
from .matching import RecordingPattern, TakeChoice
from .work.formats import LineFormat, OutputFormat
from .work.jobs import MotionForm


@dataclass(frozen=True, slots=True)
class BatchRequest:
    """A script, its recordings (a folder, or one recording that lines are cut out of), the output folder, and options.
    `columns` are headings by field, `sheets` the worksheets that are read (none: all that look alike). `options` apply
    to all lines, `cast` is the file that says who performs whom. With `has_partners` those who speak next to a line in
    its scene listen to it, with `learns_voices` the speakers' usual voices are learnt; `again` performs lines that are
    done too; `thumbnails` is the number of lines pictured in the report."""

    script: Path
    audio: Path
    out: Path
    formats: tuple[OutputFormat, ...] = (LineFormat.BML,)
    layout: Layout = field(default_factory=Layout)
    columns: Mapping[str, str] = field(default_factory=dict)
    sheets: tuple[str, ...] = ()
    pattern: RecordingPattern | None = None
    choice: TakeChoice = TakeChoice.LAST
    options: Options = field(default_factory=Options)
    motion: MotionForm = field(default_factory=MotionForm)
    cast: Path | None = None
    has_partners: bool = True
    learns_voices: bool = True
    again: bool = False
    thumbnails: int = 0
