"""What every engine can do."""

from concurrent.futures import Future
from typing import Protocol

from ...performance import SpeakerReference
from ..work.jobs import LineJob, LineOutcome
from ..work.speaking import ReferenceJob


class WorkerDiedError(Exception):
    """The worker died of the job, or of one that it had beside it. What a job's future raises besides is the job's own
    trouble."""


class Engine(Protocol):
    """Does jobs, some at a time. What its futures raise is an error of the job, or `WorkerDiedError`."""

    @property
    def places(self) -> int:
        """How many jobs it may be given at a time."""

    def submit(self, job: LineJob) -> "Future[LineOutcome]":
        """Begins a job; there is a place for it."""

    def learn(self, job: ReferenceJob) -> "Future[SpeakerReference | None]":
        """Begins to learn a speaker's voice; there is a place for it."""

    def close(self) -> None:
        """Ends at once whatever is under way."""
