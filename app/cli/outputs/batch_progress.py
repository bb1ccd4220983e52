"""Shows the progress of a batch in the chosen voice: a bar on a terminal, otherwise a line from time to time, JSON
lines for machines."""

import sys
import time
from typing import Any, Self

from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TaskID, TextColumn, TimeRemainingColumn

from ...batch.manifest.entries import ManifestEntry, State
from ...batch.planning import BatchPlan, without_audio
from ..log import Audience, Log

EVERY_S = 10.0
"""The time between two lines of progress without a terminal."""

MOST_TOLD = 50
"""The most problems of a script that are listed; the report has all."""


class BatchProgress:
    """Reports a batch's progress; also a context manager, because a bar has to be removed at the end."""

    def __init__(self, log: Log) -> None:
        self._log = log
        self._total = self._done = self._failed = 0
        self._audio_s = 0.0
        self._began_s = self._told_s = time.monotonic()
        self._performed = 0

    def planned(self, plan: BatchPlan) -> None:
        problems = [f"{plan.script.path}, {problem}" for problem in plan.script.problems]
        problems += [
            f"{plan.script.path}, {without_audio(missing, plan.script.unit)}" for missing in plan.joined.missing
        ]
        for remark in plan.remarks:
            self._log.note(remark)
        for problem in problems[:MOST_TOLD]:
            self._log.problem(problem)
        if len(problems) > MOST_TOLD:
            self._log.problem(f"and {len(problems) - MOST_TOLD} more; report.csv has all")

    def learning(self, voices: int) -> None:
        self._log.event("voices", {"speakers": voices}, f"learning how {voices} speakers usually sound")

    def begun(self, entries: int, done: int) -> None:
        self._total, self._done = entries, done
        self._began_s = self._told_s = time.monotonic()
        self._log.event("batch", {"lines": entries, "done": done}, f"{entries} lines, {done} of them done already")

    def ended(self, entry: ManifestEntry) -> None:
        self._done += 1
        self._performed += 1
        self._failed += entry.state is State.FAILED
        self._audio_s += entry.measures.duration_s if entry.measures else 0.0
        fields = {"id": entry.id, "state": entry.state.value, "seconds": entry.seconds}
        if entry.failure is not None:
            fields |= {"code": entry.failure.code, "message": entry.failure.message}
        message = f"{entry.id}: {entry.failure.message}" if entry.failure else ""
        self._log.event("line", {**fields, **self._figures()}, message)
        self._show()

    def _show(self) -> None:
        """A line of progress, if the time for one has come."""
        now_s = time.monotonic()
        if now_s - self._told_s >= EVERY_S or self._done == self._total:
            self._told_s = now_s
            self._log.progress(self._summary())

    def _figures(self) -> dict[str, Any]:
        elapsed_s = max(time.monotonic() - self._began_s, 1e-3)
        rate = self._performed / elapsed_s
        return {
            "done": self._done,
            "lines": self._total,
            "failed": self._failed,
            "audio_hours": round(self._audio_s / 3600, 4),
            "lines_an_hour": round(3600 * rate),
            "seconds_left": round((self._total - self._done) / rate),
        }

    def _summary(self) -> str:
        told = self._figures()
        return (
            f"{told['done']} of {told['lines']} lines, {told['audio_hours']:.2f} hours of audio, "
            f"{told['lines_an_hour']} lines an hour, {told['seconds_left']} s left, {told['failed']} failed"
        )

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_exception: object) -> None:
        pass


class BatchBar(BatchProgress):
    """The same on a terminal, as a bar."""

    def __init__(self, log: Log) -> None:
        super().__init__(log)
        columns = (BarColumn(), MofNCompleteColumn(), TextColumn("{task.description}"), TimeRemainingColumn())
        self._bar = Progress(*columns, console=Console(stderr=True), transient=True)
        self._task: TaskID | None = None

    def begun(self, entries: int, done: int) -> None:
        super().begun(entries, done)
        self._bar.start()
        self._task = self._bar.add_task("", total=entries, completed=done)

    def _show(self) -> None:
        if self._task is not None:
            told = self._figures()
            description = (
                f"{told['audio_hours']:.2f} h of audio, {told['lines_an_hour']} lines an hour, {told['failed']} failed"
            )
            self._bar.update(self._task, completed=self._done, description=description)

    def __exit__(self, *exception: object) -> None:
        self._bar.stop()
        super().__exit__(*exception)


def progress_for(log: Log) -> BatchProgress:
    """A bar for people at a terminal, else lines."""
    return BatchBar(log) if log.voice is Audience.PEOPLE and sys.stderr.isatty() else BatchProgress(log)
