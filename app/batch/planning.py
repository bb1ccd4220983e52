"""The request for a batch, and its plan: turns a script and its recordings into jobs, and into failures for lines that
cannot become jobs.

A job has its author's edits: those named in the script, else the file `ID.edits.json` beside the recording, where ID is
that of the take, that of the line or the recording's own name.
"""

import os
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cache
from pathlib import Path

from ..errors import InputError
from ..files import read_regular
from ..model.edits import NO_EDITS, Edits
from ..model.voice.signal import SpeakerReference
from ..models import load_characters
from ..options import Options
from ..schemas.edits import read_edits
from .audio import AudioSource, advice, converter, is_compressed
from .casting import NOBODY_CAST, CastingPlan, read_cast
from .layout import Layout, file_name, require_apart
from .manifest.entries import ManifestEntry, State
from .matching import (
    JoinedLines,
    RecordingPattern,
    TakeChoice,
    UnmatchedLine,
    find_recordings,
    join_one_recording,
    join_recordings,
)
from .model import RowProblem, Script, Take, place_told
from .scripts.reading import read_script
from .voices import reference_jobs, speaker_of
from .work.formats import LineFormat, OutputFormat
from .work.jobs import Failure, LineJob, MotionForm, ReferenceJob


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


@dataclass(frozen=True, slots=True)
class BatchPlan:
    """What a batch has to do: the script, its lines matched with recordings, a job for each line that can be performed,
    and one for each speaker whose voice is to be learnt; `remarks` say what was guessed, or has no effect."""

    script: Script
    joined: JoinedLines
    jobs: tuple[tuple[Take, LineJob], ...]
    voices: tuple[ReferenceJob, ...]
    remarks: tuple[str, ...]


def plan_batch(request: BatchRequest) -> BatchPlan:
    """Raises InputError for a script, recordings or options that cannot be used at all; problems of single lines are
    part of the plan."""
    script = read_script(request.script, request.columns, request.sheets)
    characters = load_characters().by_name
    cast = read_cast(request.cast, frozenset(characters)) if request.cast else NOBODY_CAST
    casting = CastingPlan.of(cast, request.options, characters, script.lines, has_partners=request.has_partners)
    joined = _joined(request, script)
    edits, problems = edits_of_takes(joined.takes)
    wrong = {problem.id for problem in problems}
    jobs = tuple(
        (take, _job(request, take, casting.options(take).with_edits(edits.get(take.id, NO_EDITS))))
        for take in joined.takes
        if take.id not in wrong
    )
    require_apart((take.id, target) for take, job in jobs for target in job.targets)
    _require_spared(request, jobs)
    voices = reference_jobs(_to_learn(casting, jobs)) if request.learns_voices else ()
    told = (replace(problem, unit=script.unit) for problem in problems)
    script = replace(script, problems=(*script.problems, *told))
    return BatchPlan(script, joined, jobs, voices, (*script.remarks, *casting.remarks(script.lines)))


def with_voices(plan: BatchPlan, learnt: Mapping[str, SpeakerReference]) -> BatchPlan:
    """The plan with the learnt references, by speaker."""
    jobs = tuple((take, _with_voice(job, learnt.get(speaker_of(take.line.character)))) for take, job in plan.jobs)
    return replace(plan, jobs=jobs)


def entry_of(place: int, take: Take, job: LineJob, *, input_hash: str, settings_hash: str) -> ManifestEntry:
    """A line that waits to be performed, as a row of the manifest."""
    line, interval = take.line, job.audio.interval
    return ManifestEntry(
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


def hopeless_entries(plan: BatchPlan) -> Iterator[ManifestEntry]:
    """The rows of lines that cannot be performed: problems in the script, then lines without a recording. Their ids
    differ from those of the other lines."""
    used = {job.id for _take, job in plan.jobs}
    place = len(plan.jobs)
    for problem in _one_a_row(plan.script.problems):
        yield _failed(place, problem.row, problem.id, _failure(problem), used, sheet=problem.sheet)
        place += 1
    for missing in plan.joined.missing:
        failure = Failure("audio_missing", without_audio(missing, plan.script.unit))
        line = missing.line
        entry = _failed(place, line.row, line.id, failure, used)
        yield replace(entry, character=line.character, text=line.text, comment=line.comment)
        place += 1


def without_audio(missing: UnmatchedLine, unit: str = "row") -> str:
    """The message about a line without a recording; `unit` is what rows are called in the script."""
    hint = f"; did you mean {missing.near!r}?" if missing.near else ""
    hint = f": {advice(missing.unreadable)}" if missing.unreadable else hint
    return f"{place_told(missing.line.row, missing.line.sheet, unit)}: no recording{hint}"


def _joined(request: BatchRequest, script: Script) -> JoinedLines:
    """Matches lines and recordings. Lines with times are cut out of one recording: the one given, or the one named like
    the script."""
    if request.audio.is_file():
        return join_one_recording(script.lines, request.audio)
    files = find_recordings(request.audio, without=request.out)
    if script.lines and all(line.interval and not line.recording for line in script.lines):
        whole = [file.path for file in files if file.stem.casefold() == script.path.stem.casefold()]
        if len(whole) == 1:
            return join_one_recording(script.lines, whole[0])
    unreadable = [] if converter() else [file for file in files if is_compressed(file.path)]
    readable = [file for file in files if file not in unreadable]
    return join_recordings(script.lines, readable, request.pattern, request.choice, unreadable=unreadable)


def _job(request: BatchRequest, take: Take, options: Options) -> LineJob:
    return LineJob(
        id=take.id,
        text=take.line.text,
        audio=AudioSource(take.recording.path, interval=take.recording.interval),
        options=options,
        targets=request.layout.targets(take, request.formats),
        direction=take.line.direction,
        motion=request.motion,
        folder=request.out,
    )


def _with_voice(job: LineJob, reference: SpeakerReference | None) -> LineJob:
    return job if reference is None else replace(job, options=replace(job.options, reference=reference))


def _to_learn(casting: CastingPlan, jobs: Sequence[tuple[Take, LineJob]]) -> Iterator[tuple[str, AudioSource]]:
    for take, job in jobs:
        if casting.is_learnt(take.line.character):
            yield take.line.character, job.audio


def _require_spared(request: BatchRequest, jobs: Sequence[tuple[Take, LineJob]]) -> None:
    """Raises InputError `files_same` when an output would overwrite the script or a recording."""
    folders = cache(os.path.realpath)  # each folder is resolved once, because following links is slow
    spared = {f"{folders(path.parent)}/{path.name}" for path in (request.script, *(job.audio.path for _t, job in jobs))}
    out = folders(request.out)
    for _take, job in jobs:
        for target in job.targets:
            if f"{out}/{target.path}" in spared:
                message = f"{target.path} in {request.out} is an input; nothing was written, give another --out"
                raise InputError("files_same", message, field="out")


def _one_a_row(problems: Sequence[RowProblem]) -> Iterator[RowProblem]:
    """The problems, those of a row combined into one."""
    by_row: dict[tuple[str, int], RowProblem] = {}
    for problem in problems:
        known = by_row.get((problem.sheet, problem.row))
        by_row[problem.sheet, problem.row] = (
            problem if known is None else replace(known, message=f"{known.message}; {problem.message}")
        )
    yield from by_row.values()


def _failure(problem: RowProblem) -> Failure:
    return Failure(problem.code, str(problem))


def _failed(place: int, row: int, name: str, failure: Failure, used: set[str], *, sheet: str = "") -> ManifestEntry:
    unique = name if name and name not in used else f"{name} ({place_told(row, sheet)})".strip()
    used.add(unique)
    return ManifestEntry(unique, place, row, "", "", "", "", "", None, None, "", "", State.FAILED, failure=failure)


ENDING = ".edits.json"


def edits_of_takes(takes: Iterable[Take]) -> tuple[Mapping[str, Edits], tuple[RowProblem, ...]]:
    """The edits by the id of the take, for takes that have any, and the problems with files of edits."""
    found, problems = dict[str, Edits](), list[RowProblem]()
    for take in takes:
        path = _path(take)
        try:
            if take.line.edits is not None:
                found[take.id] = take.line.edits
            elif path is not None:
                found[take.id] = read_edits(read_regular(path))
        except InputError as error:
            problems.append(RowProblem(take.line.row, "", error.code, f"{path}: {error.message}", take.id))
        except OSError as error:
            message = f"{path}: cannot be read: {error.strerror}"
            problems.append(RowProblem(take.line.row, "", "file_unreadable", message, take.id))
    return found, tuple(problems)


def _path(take: Take) -> Path | None:
    folder, names = take.recording.path.parent, (take.id, take.line.id, take.recording.path.stem)
    paths = (folder / f"{file_name(name)}{ENDING}" for name in names)
    return next((path for path in paths if path.is_file()), None)
