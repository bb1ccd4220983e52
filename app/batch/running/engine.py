"""The interface of engines."""

from concurrent.futures import Future
from typing import Protocol

from ...model.voice.signal import SpeakerReference
from ..work.jobs import LineJob, LineOutcome
from ..work.speaking import ReferenceJob


class WorkerDiedError(Exception):
    """The worker died of the job, or of another that it ran at the same time. Other errors of a job's future are the
    job's own."""


class Engine(Protocol):
    """Executes jobs, several at a time. Its futures raise an error of the job, or `WorkerDiedError`."""

    @property
    def places(self) -> int:
        """How many jobs it takes at a time."""

    def submit(self, job: LineJob) -> "Future[LineOutcome]":
        """Begins a job; called only when one more can be taken."""

    def learn(self, job: ReferenceJob) -> "Future[SpeakerReference | None]":
        """Begins to learn a speaker's voice; called only when one more can be taken."""

    def close(self) -> None:
        """Aborts whatever is running."""
