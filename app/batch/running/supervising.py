"""Has every job done, whatever happens to workers.

A job whose worker died is a suspect: it may have killed the worker, or stood beside the one that did. Suspects are
tried a second time when all others are done, each alone, so that only the culprit fails. Trouble of our own, such as
the aligner's death, has a second try as well.
"""

from collections import deque
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import FIRST_COMPLETED, Future, wait
from dataclasses import dataclass
from typing import Generic, TypeVar

from ...errors import ServiceError, UnderstudyError
from ..work.jobs import Failure
from .engine import WorkerDiedError

Job = TypeVar("Job")
Result = TypeVar("Result")

WORKER_DIED = Failure(
    "worker_died", "its worker died twice while it was performed, the second time alone: out of memory, or a fault"
)


@dataclass(frozen=True, slots=True)
class Done(Generic[Job, Result]):
    """A job with its result, or why there is none."""

    job: Job
    result: Result | None
    failure: Failure | None = None


def supervise(
    jobs: Iterable[Job], submit: Callable[[Job], "Future[Result]"], *, places: int
) -> Iterator[Done[Job, Result]]:
    """The jobs as they are done, in no order; jobs are taken from `jobs` as places become free."""
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
    """The jobs with their ended futures; no more than `places` are under way."""
    waiting = iter(jobs)
    running: dict[Future[Result], Job] = {}
    ended: list[tuple[Job, Future[Result]]] = []
    while True:
        while len(running) < places and (job := next(waiting, None)) is not None:
            running[submit(job)] = job
        yield from ended  # only now, so that no worker waits for what is made of them
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
