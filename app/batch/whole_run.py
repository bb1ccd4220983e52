"""Runs a whole batch: plans it, looks up what is done already, has the rest performed, writes the reports.

The manifest is updated as each line ends, after its files are written. So if the process is killed at any time, the
same command continues with what was not finished, and no line counts as done whose files are missing. A full disk ends
the batch, since nothing that is performed then can be kept; lines under way are aborted and wait for the same command.

The interface by which a batch reports its progress.
"""

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import ExitStack, closing
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Protocol

from ..errors import InputError
from ..loading import OnDemand
from ..model.voice.signal import SpeakerReference
from ..settings import Settings
from .manifest.entries import ManifestEntry, State, WrittenFile
from .manifest.hashes import KnownRecording, input_hash, installation_hash, settings_hash
from .manifest.store import FILE, Manifest
from .planning import BatchPlan, BatchRequest, entry_of, hopeless_entries, plan_batch, with_voices
from .reports.html_report import Heading, Thumbnail
from .reports.writing import remove_reports, reports_are_there, write_reports
from .running.engine import Done, Engine, supervise
from .thumbnails import read_thumbnails, remove_other_thumbnails, thumbnail_jobs, thumbnail_paths
from .voices import keep_learnt, read_learnt
from .work.files import clear_unfinished, unwritable, write_files
from .work.formats import extension_of
from .work.jobs import Failure, LineJob, LineOutcome, ReferenceJob


@dataclass(frozen=True, slots=True)
class Work:
    """A line to be performed: its row in the manifest and its job."""

    entry: ManifestEntry
    job: LineJob


class Watcher(Protocol):
    """Is notified of a batch's progress."""

    def planned(self, plan: BatchPlan) -> None:
        """The script has been read and its lines matched with recordings."""

    def learning(self, voices: int) -> None:
        """So many voices are about to be learnt."""

    def begun(self, entries: int, done: int) -> None:
        """So many lines can be performed, and so many of them are done already."""

    def ended(self, entry: ManifestEntry) -> None:
        """A line is done, or has failed."""


def run_batch(
    request: BatchRequest, settings: Settings, make_engine: Callable[[], Engine], watcher: Watcher
) -> tuple[ManifestEntry, ...]:
    """Performs what is not done and returns the rows of all lines. `make_engine` is called only if there is something
    to do.

    Raises InputError for input that cannot be used at all, and `disk_full`; problems of single lines are reported in
    their rows.
    """
    plan = plan_batch(request)
    watcher.planned(plan)
    try:
        return _run(plan, request, settings, make_engine, watcher)
    except OSError as error:
        raise unwritable(error, request.out) from None


def _run(
    plan: BatchPlan, request: BatchRequest, settings: Settings, make_engine: Callable[[], Engine], watcher: Watcher
) -> tuple[ManifestEntry, ...]:
    """As `run_batch`; raises OSError where a report, a reference or a picture cannot be written."""
    with Manifest(request.out) as manifest, ExitStack() as stack:
        engine = OnDemand(lambda: stack.enter_context(closing(make_engine())))
        clear_unfinished(request.out)
        before = manifest.entries()
        plan = with_voices(plan, _voices(plan.voices, engine, request.out, watcher))
        work = _work(plan, settings, manifest)
        changed = _changed(plan, work, before, request)
        if not changed.is_nothing:
            remove_reports(request.out)  # so that a kill leaves no older ones
            manifest.remove(changed.gone)
            manifest.put(changed.rows)
        watcher.begun(len(work), len(work) - len(changed.waiting))
        for entry in _performed(changed.waiting, engine, request.out):
            _remove_old(before.get(entry.id), entry, request.out)
            manifest.put([entry])
            watcher.ended(entry)
        entries = tuple((before if changed.is_nothing else manifest.entries()).values())
        thumbnails = _thumbnails(request, plan, entries, engine)
        clear_unfinished(request.out)
    if thumbnails or not reports_are_there(request.out):
        write_reports(request.out, Heading(request.script.name, plan.script.unit), entries, thumbnails)
    return entries


def entries_before(out: Path) -> dict[str, ManifestEntry]:
    """The rows of an earlier run, none where there was none; raises InputError as `Manifest` does."""
    if not (out / FILE).exists():
        return {}
    with Manifest(out) as manifest:
        return manifest.entries()


@dataclass(frozen=True, slots=True)
class BatchChanges:
    """The differences from the manifest: lines to perform, rows to write first, and ids that are gone."""

    waiting: tuple[Work, ...]
    rows: tuple[ManifestEntry, ...]
    gone: frozenset[str]

    @property
    def is_nothing(self) -> bool:
        return not (self.waiting or self.rows or self.gone)


def _changed(
    plan: BatchPlan, work: Sequence[Work], before: Mapping[str, ManifestEntry], request: BatchRequest
) -> BatchChanges:
    hopeless = list(hopeless_entries(plan))
    waiting = [each for each in work if request.again or not _is_done(before.get(each.entry.id), each, request.out)]
    ids = {each.entry.id for each in work} | {entry.id for entry in hopeless}
    rows = [*(entry for entry in hopeless if before.get(entry.id) != entry), *_begun(work, waiting, before)]
    return BatchChanges(tuple(waiting), tuple(rows), frozenset(before.keys() - ids))


def _thumbnails(
    request: BatchRequest, plan: BatchPlan, entries: Sequence[ManifestEntry], engine: OnDemand[Engine]
) -> dict[str, Thumbnail]:
    """Contact sheets of the lines most in need of a check, drawn where they do not exist yet."""
    paths = thumbnail_paths(entries, request.thumbnails)
    jobs = list(thumbnail_jobs([job for _take, job in plan.jobs], paths, request.out))
    if jobs:
        for done in supervise(jobs, lambda job: engine.get().submit(job), places=engine.get().places):
            _require_room(done.failure)
            if done.result is not None:
                write_files(request.out, done.result.files)
    remove_other_thumbnails(paths, request.out)
    return read_thumbnails(paths, request.out)


def _work(plan: BatchPlan, settings: Settings, manifest: Manifest) -> list[Work]:
    """The lines with their hashes; recordings are read only if they have changed."""
    known = manifest.known_recordings()
    hashes: dict[str, KnownRecording] = {}
    installation = installation_hash()
    work = []
    for place, (take, job) in enumerate(plan.jobs):
        path = str(job.audio.path)
        if path not in hashes:
            hashes[path] = KnownRecording.of(job.audio.path, known.get(path))
        of_input = input_hash(job, hashes[path].hash)
        of_settings = settings_hash(job, settings, installation)
        work.append(Work(entry_of(place, take, job, input_hash=of_input, settings_hash=of_settings), job))
    manifest.know_recordings((path, each) for path, each in hashes.items() if known.get(path) != each)
    return work


def _is_done(before: ManifestEntry | None, work: Work, out: Path) -> bool:
    """Whether a line was performed from the same input, and its files are all there."""
    return (
        before is not None
        and before.state is State.DONE
        and before.is_made_of_the_same(work.entry)
        and all(_size(out / file.path) == file.size for file in before.outputs)
    )


def _size(path: Path) -> int | None:
    try:
        return path.stat().st_size
    except OSError:
        return None


def _begun(
    work: Sequence[Work], waiting: Sequence[Work], before: Mapping[str, ManifestEntry]
) -> Iterator[ManifestEntry]:
    """The rows that change before anything is performed: those that wait, and those that moved in the script."""
    waits = {each.entry.id for each in waiting}
    for each in work:
        entry, known = each.entry, before.get(each.entry.id)
        if entry.id in waits:
            yield replace(entry, outputs=known.outputs if known else ())
        elif known is not None and (known.place, known.row) != (entry.place, entry.row):
            yield replace(known, place=entry.place, row=entry.row)


def _voices(
    jobs: Sequence[ReferenceJob], engine: OnDemand[Engine], out: Path, watcher: Watcher
) -> dict[str, SpeakerReference]:
    """The speakers' references; those not learnt before are learnt now. A voice that cannot be analysed has none."""
    voices = read_learnt(out, jobs)
    unknown = [job for job in jobs if job.speaker not in voices]
    if unknown:
        watcher.learning(len(unknown))
        for done in supervise(unknown, engine.get().learn, places=engine.get().places):
            if done.result is not None:
                keep_learnt(out, done.job.speaker, done.result)
                voices[done.job.speaker] = done.result
    return voices


def _performed(waiting: Sequence[Work], engine: OnDemand[Engine], out: Path) -> Iterator[ManifestEntry]:
    """The rows of the lines, as each line ends. Raises InputError `disk_full`."""
    if waiting:
        for done in supervise(waiting, lambda work: engine.get().submit(work.job), places=engine.get().places):
            entry = _entry(done, out)
            _require_room(entry.failure)
            yield entry


def _require_room(failure: Failure | None) -> None:
    """Raises InputError `disk_full` where that is why a line failed: the next ones would be performed for nothing."""
    if failure is not None and failure.code == "disk_full":
        raise InputError("disk_full", failure.message, field="out")


def _entry(done: Done[Work, LineOutcome], out: Path) -> ManifestEntry:
    entry, outcome = done.job.entry, done.result
    if outcome is None or outcome.failure is not None:
        failure = outcome.failure if outcome else done.failure
        return replace(entry, state=State.FAILED, failure=failure, seconds=outcome.seconds if outcome else None)
    try:
        files = write_files(out, outcome.files)
    except OSError as error:
        return replace(entry, state=State.FAILED, failure=Failure.of(unwritable(error, out)))
    return replace(
        entry,
        state=State.DONE,
        outputs=tuple(WrittenFile(extension_of(file.form), file.listener, file.path, file.size) for file in files),
        warnings=outcome.notices,
        measures=outcome.measures,
        seconds=round(outcome.seconds, 3),
    )


def _remove_old(before: ManifestEntry | None, entry: ManifestEntry, out: Path) -> None:
    """Removes files of the line's former version that it no longer has."""
    kept = {file.path for file in entry.outputs}
    for file in before.outputs if before else ():
        if file.path not in kept:
            (out / file.path).unlink(missing_ok=True)


class Nobody:
    """Ignores all notifications."""

    def planned(self, plan: BatchPlan) -> None:
        pass

    def learning(self, voices: int) -> None:
        pass

    def begun(self, entries: int, done: int) -> None:
        pass

    def ended(self, entry: ManifestEntry) -> None:
        pass
