"""Describes what a batch would do, as text: lines by character, what is missing, unused or duplicate, how long it would
take.

The estimate counts seconds of one processor of the machine on which `python -m benchmarks.batch.costs` measured them
(docs/measurements/batch.md, "Batch").
"""

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from types import MappingProxyType

import soundfile

from ...model import Interval
from ...model.formats import MotionFormat
from ..audio import is_compressed
from ..manifest.entries import ManifestEntry, State
from ..matching import NearNames
from ..model import place_told
from ..planning import BatchPlan, without_audio
from ..work.formats import OutputFormat, needs_motion
from ..work.jobs import LineJob

MOST_TOLD = 40
FIRST_LINES = 3


@dataclass(frozen=True, slots=True)
class DryRun:
    """The description, in lines of text; `is_whole` says whether every row of the script would be performed."""

    lines: tuple[str, ...]
    is_whole: bool


def dry_run(plan: BatchPlan, before: Mapping[str, ManifestEntry], *, workers: int, thumbnails: int = 0) -> DryRun:
    """What would be done by so many workers; `before` is the manifest of an earlier run, `thumbnails` the number of
    lines that the report pictures."""
    durations_s = {job.id: _duration_s(job) for _take, job in plan.jobs}
    problems = [str(problem) for problem in plan.script.problems]
    unit = plan.script.unit
    missing = [f"{each.line.id}, {without_audio(each, unit)}" for each in plan.joined.missing]
    unreadable = [str(job.audio.path) for _take, job in plan.jobs if durations_s[job.id] is None]
    sections = {
        f"wrong {unit}s": problems,
        "lines without audio": missing,
        "audio that cannot be read": unreadable,
        "audio without lines": list(_unused(plan)),
        "several recordings of one take (the first is performed)": list(_rivals(plan)),
        "one recording of several lines": list(_shared(plan)),
    }
    told = [
        *_understood(plan),
        *_speakers(plan, durations_s),
        *_sections(sections),
        "",
        _summary(plan, durations_s, _expected_s(plan, durations_s, before, thumbnails), workers),
    ]
    return DryRun(tuple(told), not (problems or missing or unreadable))


def _understood(plan: BatchPlan) -> Iterator[str]:
    """Which column is taken for what, the first lines as they were read, and what was guessed or left out."""
    script = plan.script
    for field, heading in script.columns:
        yield f"{field or '(not used)':12s} <- {heading}"
    for line in script.lines[:FIRST_LINES]:
        who = f"{line.character}: " if line.character else ""
        yield f"{place_told(line.row, line.sheet, script.unit)}, {line.id}: {who}{line.text}"
    yield from plan.remarks
    yield ""


def _speakers(plan: BatchPlan, durations_s: Mapping[str, float | None]) -> Iterator[str]:
    lines = Counter(take.line.character for take, _job in plan.jobs)
    performers: dict[str, set[str]] = {}
    seconds: Counter[str] = Counter()
    for take, job in plan.jobs:
        performers.setdefault(take.line.character, set()).add(job.options.character)
        seconds[take.line.character] += round(durations_s[job.id] or 0.0)
    yield f"{'character':28s} {'performed by':20s} {'lines':>6s} {'minutes':>8s}"
    for name, count in lines.most_common():
        by = ", ".join(sorted(performers[name]))
        yield f"{name or '(nobody named)':28.28s} {by:20.20s} {count:6d} {seconds[name] / 60:8.1f}"


def _sections(sections: Mapping[str, Sequence[str]]) -> Iterator[str]:
    for title, rows in sections.items():
        if rows:
            yield ""
            yield f"{title}: {len(rows)}"
            yield from (f"  {row}" for row in rows[:MOST_TOLD])
        if len(rows) > MOST_TOLD:
            yield f"  and {len(rows) - MOST_TOLD} more"


def _unused(plan: BatchPlan) -> Iterator[str]:
    near = NearNames(missing.line.id for missing in plan.joined.missing)
    for path in plan.joined.unused:
        meant = near.nearest(path.stem)
        yield f"{path.name}: did you mean {meant}?" if meant else path.name


def _rivals(plan: BatchPlan) -> Iterator[str]:
    for line, paths in plan.joined.rivals:
        yield f"{line.id}: {', '.join(map(str, paths))}"


def _shared(plan: BatchPlan) -> Iterator[str]:
    for path, lines in plan.joined.shared:
        yield f"{path.name}: {', '.join(line.id for line in lines)}"


@dataclass(frozen=True, slots=True)
class _Expected:
    """The number of lines to perform, the seconds that they take together, and those that more workers do not
    shorten."""

    lines: int
    shared_s: float
    whole_s: float


def _summary(plan: BatchPlan, durations_s: Mapping[str, float | None], expected: "_Expected", workers: int) -> str:
    total_s = sum(duration_s or 0.0 for duration_s in durations_s.values())
    expected_s = expected.whole_s + expected.shared_s / workers
    return (
        f"{len(plan.jobs)} lines with recordings, {total_s / 3600:.2f} hours; {expected.lines} to perform, "
        f"about {_time(expected_s)} with {workers} workers, formats, listeners and pictures included"
    )


def _expected_s(
    plan: BatchPlan, durations_s: Mapping[str, float | None], before: Mapping[str, ManifestEntry], thumbnails: int
) -> _Expected:
    waiting = [job for _take, job in plan.jobs if (old := before.get(job.id)) is None or old.state is not State.DONE]
    lasting_s = [durations_s[job.id] or 0.0 for job in waiting]
    shared_s = sum(map(line_s, waiting, lasting_s)) + sheets_s(lasting_s[:thumbnails])
    usual_s = sum(lasting_s) / max(1, len(lasting_s))
    shared_s += VOICE * usual_s * sum(len(voice.recordings) for voice in plan.voices) if waiting else 0.0
    return _Expected(len(waiting), shared_s, LOADING_S + REPORTS_S if waiting else 0.0)


def _time(seconds: float) -> str:
    if seconds < 90:
        return f"{seconds:.0f} s"
    return f"{seconds / 60:.0f} min" if seconds < 5400 else f"{seconds / 3600:.1f} hours"


def _duration_s(job: LineJob) -> float | None:
    interval: Interval | None = job.audio.interval
    if interval is not None:
        return interval.duration_s
    return _file_duration_s(job.audio.path)


def _file_duration_s(path: Path) -> float | None:
    """The duration in the file's header; None when it cannot be read, 0 where only ffmpeg knows."""
    try:
        return float(soundfile.info(path).duration)
    except (soundfile.LibsndfileError, OSError):
        return 0.0 if is_compressed(path) else None


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
