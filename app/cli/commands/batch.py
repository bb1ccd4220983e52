"""`understudy batch`: a script and its recordings in, a performance of each line out."""

import argparse
import os
from pathlib import Path

from ...batch.layout import OURS, USUAL, Layout
from ...batch.manifest.entries import ManifestEntry, State
from ...batch.matching import RecordingPattern, TakeChoice
from ...batch.planning import BatchRequest, plan_batch
from ...batch.reports.dry_run import dry_run
from ...batch.running.engine import Engine
from ...batch.scripts.columns import read_named
from ...batch.whole_run import entries_before, run_batch
from ...batch.work.formats import formats_named, needs_pictures, require_writers
from ...batch.work.jobs import MotionForm
from ...errors import InputError
from ...library.checks import check_character
from ...library.motion_checks import check_skeleton
from ...settings import Settings, read_settings
from ..files import OutputName, require_distinct, write_standard
from ..inputs.lines import performance_options
from ..log import Log
from ..outputs.batch_progress import progress_for
from ..outputs.motions import physics_asked
from ..outputs.plot import require_plot

SOME_FAILED = 1


def run(arguments: argparse.Namespace, log: Log) -> int:
    settings = read_settings()
    require_distinct(arguments, [OutputName(Path(arguments.out) / name) for name in sorted(OURS)])
    request = _request(arguments, settings)
    check_character(request.options.character)
    check_skeleton(request.motion.skeleton)
    if needs_pictures(request.formats) or request.thumbnails:
        require_plot("sheet.png")
    require_writers(request.formats, settings)
    if arguments.service:
        from ...batch.running.service import require_served

        require_served(request.formats)
    workers = _workers(arguments.workers)
    if arguments.dry_run:
        return _dry_run(request, workers)
    with progress_for(log) as progress:
        entries = run_batch(request, settings, lambda: _engine(arguments, workers, settings), progress)
    return _told(entries, request.out, log)


def _dry_run(request: BatchRequest, workers: int) -> int:
    """Writes to standard output what would be done."""
    before = entries_before(request.out)
    told = dry_run(plan_batch(request), before, workers=workers, thumbnails=request.thumbnails)
    write_standard("\n".join((*told.lines, "")).encode())
    return 0 if told.is_whole else SOME_FAILED


def _request(arguments: argparse.Namespace, settings: Settings) -> BatchRequest:
    return BatchRequest(
        script=Path(arguments.script),
        audio=Path(arguments.audio),
        out=Path(arguments.out),
        formats=formats_named(arguments.format),
        layout=Layout(arguments.layout or USUAL),
        columns=read_named(arguments.column),
        sheets=tuple(arguments.sheet),
        pattern=RecordingPattern.of(arguments.pattern) if arguments.pattern else None,
        choice=TakeChoice(arguments.take),
        options=performance_options(arguments),
        motion=MotionForm(arguments.fps, arguments.skeleton, physics_asked(arguments, settings)),
        cast=Path(arguments.cast) if arguments.cast else None,
        has_partners=arguments.partners == "scene",
        learns_voices=arguments.voices == "learn",
        again=arguments.again,
        thumbnails=arguments.thumbnails,
    )


def _workers(told: int | None) -> int:
    workers = told if told is not None else len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else None
    if workers is None:
        workers = os.cpu_count() or 1
    if workers < 1:
        raise InputError("usage", f"--workers {workers}: give 1 at least", field="workers")
    return workers


def _engine(arguments: argparse.Namespace, workers: int, settings: Settings) -> Engine:
    if arguments.scheduler:
        from ...batch.running.dask_cluster import DaskEngine

        return DaskEngine(arguments.scheduler, settings, shares_files=arguments.shared_files)
    if arguments.service:
        from ...batch.running.service import ServiceEngine

        return ServiceEngine(arguments.service, workers, settings)
    from ...batch.running.local import LocalEngine

    return LocalEngine(workers, settings)


def _told(entries: tuple[ManifestEntry, ...], out: Path, log: Log) -> int:
    failed = [entry for entry in entries if entry.state is State.FAILED]
    done = len(entries) - len(failed)
    log.note(f"{done} lines done, {len(failed)} failed; {out / 'report.csv'} has the reason for each")
    return SOME_FAILED if failed else 0
