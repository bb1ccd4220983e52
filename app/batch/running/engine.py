"""The interface of engines, and the execution of all jobs by one, even if workers die.

A job whose worker died is a suspect: it may have killed the worker, or have run beside the one that did. Suspects are
retried after all others, one at a time, so that only the culprit fails. Failures of the service, such as the aligner's
death, are retried too.
"""

from collections import deque
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import FIRST_COMPLETED, Future, wait
from dataclasses import dataclass
from typing import Generic, Protocol, TypeVar

from ...errors import ServiceError, UnderstudyError
from ...model.voice.signal import SpeakerReference
from ..work.jobs import Failure, LineJob, LineOutcome, ReferenceJob


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


Job = TypeVar("Job")
Result = TypeVar("Result")

WORKER_DIED = Failure(
    "worker_died", "its worker died twice while it was performed, the second time alone: out of memory, or a fault"
)


@dataclass(frozen=True, slots=True)
class Done(Generic[Job, Result]):
    """A job with its result, or with the failure."""

    job: Job
    result: Result | None
    failure: Failure | None = None


def supervise(
    jobs: Iterable[Job], submit: Callable[[Job], "Future[Result]"], *, places: int
) -> Iterator[Done[Job, Result]]:
    """The jobs as they end, in any order; jobs are taken from `jobs` as the engine has room for them."""
    suspects: deque[Job] = deque()
    for job, future in _completed(jobs, submit, places):
        if _deserves_another_try(future.exception()):
            suspects.append(job)
        else:
            yield _done(job, future)
    for job, future in _completed(suspects, submit, 1):
        yield _done(job, future)


def _completed(
    jobs: Iterable[Job], submit: Callable[[Job], "Future[Result]"], places: int
) -> Iterator[tuple[Job, "Future[Result]"]]:
    """The jobs with their completed futures; at most `places` run at a time."""
    waiting = iter(jobs)
    running: dict[Future[Result], Job] = {}
    ended: list[tuple[Job, Future[Result]]] = []
    while True:
        while len(running) < places and (job := next(waiting, None)) is not None:
            running[submit(job)] = job
        yield from ended  # only after new jobs are submitted, so that no worker waits for the consumer
        if not running:
            return
        done, _others = wait(running, return_when=FIRST_COMPLETED)
        ended = [(running.pop(future), future) for future in done]


def _deserves_another_try(error: BaseException | None) -> bool:
    return isinstance(error, WorkerDiedError | ServiceError)


def _done(job: Job, future: "Future[Result]") -> Done[Job, Result]:
    error = future.exception()
    match error:
        case None:
            return Done(job, future.result())
        case WorkerDiedError():
            return Done(job, None, WORKER_DIED)
        case UnderstudyError():
            return Done(job, None, Failure(error.code, error.message))
        case _:
            return Done(job, None, Failure("internal", f"{type(error).__name__}: {error}"))
