"""From a script and its recordings to jobs, and to the failures of lines that cannot become one."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from ..performance import Options
from .layout import require_apart
from .manifest.entries import Entry, State
from .matching.joining import Joined, Missing, join_one_recording, join_recordings
from .matching.recordings import find_recordings
from .model import Problem, Script, ScriptLine, Take
from .request import BatchRequest
from .scripts.reading import read_script
from .work.audio import AudioSource
from .work.jobs import Failure, LineJob


@dataclass(frozen=True, slots=True)
class Plan:
    """What a batch has to do: the script, what was joined, and a job for each line that can be performed."""

    script: Script
    joined: Joined
    jobs: tuple[tuple[Take, LineJob], ...]


def plan_batch(request: BatchRequest) -> Plan:
    """Raises InputError for a script, recordings or options that cannot be used at all; what is wrong with single
    lines is part of the plan."""
    script = read_script(request.script, request.columns)
    joined = _joined(request, script)
    jobs = tuple((take, _job(request, take)) for take in joined.takes)
    require_apart((take.id, target) for take, job in jobs for target in job.targets)
    return Plan(script, joined, jobs)


def entry_of(place: int, take: Take, job: LineJob, *, input_hash: str, settings_hash: str) -> Entry:
    """A line that waits to be performed, as a row of the manifest."""
    line, interval = take.line, job.audio.interval
    return Entry(
        id=job.id,
        place=place,
        row=line.row,
        character=line.character,
        performer=job.options.character,
        text=line.text,
        comment=line.comment,
        audio=str(job.audio.path),
        start_s=interval.start_s if interval else None,
        end_s=interval.end_s if interval else None,
        input_hash=input_hash,
        settings_hash=settings_hash,
    )


def hopeless_entries(plan: Plan) -> Iterator[Entry]:
    """The rows of lines that cannot be performed: what is wrong in the script, then lines without a recording. Their
    ids tell them from the lines that can."""
    used = {job.id for _take, job in plan.jobs}
    place = len(plan.jobs)
    for problem in _one_a_row(plan.script.problems):
        yield _failed(place, problem.row, problem.id, _failure(problem), used)
        place += 1
    for missing in plan.joined.missing:
        failure = Failure("audio_missing", without_audio(missing))
        line = missing.line
        entry = _failed(place, line.row, line.id, failure, used)
        yield replace(entry, character=line.character, text=line.text, comment=line.comment)
        place += 1


def without_audio(missing: Missing) -> str:
    """What is told of a line without a recording."""
    hint = f"; did you mean {missing.near!r}?" if missing.near else ""
    return f"row {missing.line.row}: no recording{hint}"


def _joined(request: BatchRequest, script: Script) -> Joined:
    if request.audio.is_file():
        return join_one_recording(script.lines, request.audio)
    files = find_recordings(request.audio, without=request.out)
    return join_recordings(script.lines, files, request.pattern, request.choice)


def _job(request: BatchRequest, take: Take) -> LineJob:
    return LineJob(
        id=take.id,
        text=take.line.text,
        audio=AudioSource(take.recording.path, interval=take.recording.interval),
        options=_options(request.options, take.line, take.recording.path),
        targets=request.layout.targets(take, request.formats),
        direction=take.line.direction,
        motion=request.motion,
        folder=request.out,
    )


def _options(options: Options, line: ScriptLine, recording: Path) -> Options:
    return replace(
        options,
        agitation=line.agitation or options.agitation,
        seed=options.seed if line.seed is None else line.seed,
        form=replace(options.form, audio_name=recording.stem),
    )


def _one_a_row(problems: Sequence[Problem]) -> Iterator[Problem]:
    """The problems of a row in one."""
    by_row: dict[int, Problem] = {}
    for problem in problems:
        known = by_row.get(problem.row)
        by_row[problem.row] = (
            problem if known is None else replace(known, message=f"{known.message}; {problem.message}")
        )
    yield from by_row.values()


def _failure(problem: Problem) -> Failure:
    return Failure(problem.code, str(problem))


def _failed(place: int, row: int, name: str, failure: Failure, used: set[str]) -> Entry:
    unique = name if name and name not in used else f"{name} (row {row})".strip()
    used.add(unique)
    return Entry(unique, place, row, "", "", "", "", "", None, None, "", "", State.FAILED, failure=failure)
