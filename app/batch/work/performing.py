"""Performs the line of a job and makes its files. A pure function of the job and the models; mistakes of the caller's
are part of the outcome, because one wrong line must not stop the others."""

from __future__ import annotations

import time
from collections import Counter
from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace

import numpy as np

from ...errors import InputError
from ...library.motion import AvatarOptions, PreparedSchedule, RealizedSchedule, realize_prepared, write_realized
from ...library.performing import perform_line
from ...library.writing import (
    listener_part,
    write_bml_files,
    write_bml_json,
    write_ctm,
    write_json,
    write_textgrid,
)
from ...model import Analysis, Channel, Line, Performance
from ...model.formats import AudioFile, BmlForm, DialectName, FileOptions, MotionFormat
from ...models import Understudy
from .files import unwritable, write_files
from .formats import LineFormat, act_path, beside, needs_motion, recording_name
from .jobs import Failure, LineJob, LineOutcome, Measures, OutputFile, OutputTarget

_NOT_AS_ASKED = frozenset({"dropped", "late", "cut"})
"""The realizer's decisions that somebody may mind; a hold that is shorter or a blend nobody does."""


def perform_job(job: LineJob, models: Understudy) -> LineOutcome:
    """The outcome of a job. Raises ServiceError for failures of the service, after which a retry may succeed, and
    InputError `disk_full` or `file_unwritable` when the files cannot be written."""
    start_s = time.perf_counter()
    try:
        audio = job.audio.content()
        line = Line(audio, job.text, direction=job.direction)
        performed = perform_line(models, line, job.options)
        analysis, performance = performed.analysis, performed.performance
        realized = _realized(job, models, performance)
        files = tuple(_files(job, models, audio, performance, realized))
    except InputError as error:
        return LineOutcome(job.id, time.perf_counter() - start_s, failure=Failure.of(error))
    if job.folder is not None:
        try:
            files = write_files(job.folder, files)
        except OSError as error:
            raise unwritable(error, job.folder) from None
    measures = _measures(analysis, performance, realized.get("", None))
    return LineOutcome(job.id, time.perf_counter() - start_s, files, performance.notices, measures)


def _parts(performance: Performance) -> Iterator[tuple[str, Performance]]:
    """The speaker's part, with an empty name, then each listener's."""
    yield "", performance
    for listening in performance.listeners:
        yield listening.name, listener_part(performance, listening)


def _realized(job: LineJob, models: Understudy, performance: Performance) -> Mapping[str, RealizedSchedule]:
    """The motion of each part, if a format needs it."""
    if not needs_motion([target.form for target in job.targets]):
        return {}
    found = {}
    for name, part in _parts(performance):
        prepared = PreparedSchedule.of(part)
        how = job.motion
        found[name] = realize_prepared(models.realizer, prepared, frame_rate_hz=how.frame_rate_hz, physics=how.physics)
    return found


def _files(
    job: LineJob, models: Understudy, audio: bytes, performance: Performance, realized: Mapping[str, RealizedSchedule]
) -> Iterator[OutputFile]:
    wearer = AvatarOptions(job.motion.skeleton)
    options = FileOptions(audio=AudioFile(job.audio.path.name, audio), blender=models.acoustic.settings.blender)
    form = job.options.form
    spoken: Mapping[LineFormat, Callable[[], bytes]] = {
        LineFormat.BML_JSON: lambda: write_bml_json(performance, form=form),
        LineFormat.PERFORMANCE: lambda: write_json(performance, indent=2) + b"\n",
        LineFormat.TEXTGRID: lambda: write_textgrid(performance),
        LineFormat.CTM: lambda: write_ctm(performance, job.id),
        LineFormat.WAV: lambda: audio,
    }
    for target in job.targets:
        if isinstance(target.form, MotionFormat):
            for name, part in realized.items():
                yield _file(target, name, write_realized(part, models.realizer, target.form, wearer, options))
        elif target.form is LineFormat.BML:
            yield from _bml_files(target, performance, form)
        else:
            yield _file(target, "", spoken[target.form]())


def _bml_files(target: OutputTarget, performance: Performance, form: BmlForm) -> Iterator[OutputFile]:
    """The speaker's BML and each listener's. SmartBody's act is in the same folder as the file with words and visemes,
    which is named after the line."""
    if form.dialect is DialectName.SMARTBODY:
        form = replace(form, audio_file=recording_name(target.path))
    files = write_bml_files(performance, form)
    if files.speech:
        yield _file(target, "", files.speech.content)
        target = replace(target, path=act_path(target.path))
    yield _file(target, "", files.speaker)
    for name, content in files.listeners.items():
        yield _file(target, name, content)


def _file(target: OutputTarget, listener: str, content: bytes) -> OutputFile:
    path = beside(target.path, listener, target.form) if listener else target.path
    return OutputFile(target.form, path, len(content), listener, content)


def _measures(analysis: Analysis, performance: Performance, realized: RealizedSchedule | None) -> Measures:
    utterance = performance.utterance
    kept = [behavior for behavior in performance.behaviors if behavior.kept]
    gestures = [behavior for behavior in performance.behaviors if behavior.kind is Channel.GESTURE]
    functions = Counter(function.class_name for function in performance.functions if function.kept)
    return Measures(
        duration_s=round(analysis.utterance.duration_s or 0.0, 3),
        words=len(utterance.words),
        agitation=utterance.agitation.level.value if utterance.agitation else "",
        functions=dict(sorted(functions.items())),
        gestures=sum(gesture.kept for gesture in gestures),
        gestures_dropped=sum(not gesture.kept for gesture in gestures),
        behaviors=len(kept),
        emphasised=sum(word.is_emphasised for word in utterance.words),
        pitch_spread_st=_pitch_spread_st(analysis),
        unplayed=None if realized is None else _unplayed(realized),
    )


def _unplayed(realized: RealizedSchedule) -> int:
    """The number of movements that are missing or come late."""
    return sum(decision.action in _NOT_AS_ASKED for decision in realized.motion.decisions)


def _pitch_spread_st(analysis: Analysis) -> float | None:
    """The standard deviation of the pitch, in semitones; None if there is none."""
    f0_hz = analysis.heard.contours.f0_hz if analysis.heard else np.zeros(0)
    voiced_hz = f0_hz[f0_hz > 0]
    return round(float(np.std(12 * np.log2(voiced_hz))), 2) if len(voiced_hz) > 1 else None
