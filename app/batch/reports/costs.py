"""What lines cost the processor, for the estimate of a dry run.

Seconds are those of one processor of the machine on which `python -m benchmarks.batch.costs` measured them
(docs/measurements/batch.md, "Batch").
"""

from collections.abc import Iterable, Mapping
from types import MappingProxyType

from ...model.formats.motion_formats import MotionFormat
from ..work.formats import OutputFormat, needs_motion
from ..work.jobs import LineJob

LINE_S, SPEECH = 0.03, 0.025
"""Seconds for a line, and for a second of its speech."""

LISTENER, MOTION = 0.003, 0.006
"""Seconds for a second of speech: for each listener, and for the motion of each body."""

VOICE = 0.01
"""Seconds for a second of a recording from which a voice is learnt."""

SHEET_S = 0.2
"""What a contact sheet takes beside `_FORMATS`: the line is performed again for it."""

LOADING_S, REPORTS_S = 4.0, 2.0

_FORMATS: Mapping[OutputFormat, float] = MappingProxyType(
    {
        MotionFormat.SHEET: 0.15,
        MotionFormat.SPEEDS: 0.04,
        MotionFormat.USDA: 0.022,
        MotionFormat.USDC: 0.013,
        MotionFormat.USDZ: 0.017,
        MotionFormat.GLB: 0.004,
        MotionFormat.BVH: 0.003,
        MotionFormat.JSON: 0.003,
        MotionFormat.FBX: 1.0,
    }
)
_OTHER_FORMAT = 0.002
"""Seconds for a second of speech, in each format, for each body if it is motion."""


def line_s(job: LineJob, duration_s: float) -> float:
    """The expected seconds for a line with its listeners and formats."""
    forms = [target.form for target in job.targets]
    bodies = 1 + len(job.options.listeners)
    each = SPEECH + LISTENER * (bodies - 1) + (MOTION * bodies if needs_motion(forms) else 0.0)
    each += sum(_FORMATS.get(form, _OTHER_FORMAT) * (bodies if isinstance(form, MotionFormat) else 1) for form in forms)
    return LINE_S + each * duration_s


def sheets_s(durations_s: Iterable[float]) -> float:
    """The expected seconds for the contact sheets of lines in the report."""
    return sum(SHEET_S + (SPEECH + MOTION + _FORMATS[MotionFormat.SHEET]) * duration_s for duration_s in durations_s)
