"""A dask cluster as an engine (the extra `cluster`): recordings are sent and files returned or, where workers share the
folders, read and written there.

The scheduler itself retries a task whose worker died, as often as its `allowed-failures` says (3), then gives it up
together with any others in the same worker; the supervisor finds the culprit.

Prepares jobs for workers on other machines: with the recordings in them, their outputs to be sent back.
"""

from __future__ import annotations

from collections.abc import Callable
from concurrent.futures import Future
from dataclasses import replace
from typing import TYPE_CHECKING, ParamSpec, TypeVar

from ...errors import InputError, ServiceError
from ...model.voice.signal import SpeakerReference
from ...settings import Settings
from ...version import __version__
from ..work.jobs import Failure, LineJob, LineOutcome, ReferenceJob
from ..work.worker import learn_in_worker, perform_in_worker, version_in_worker
from .engine import WorkerDiedError

if TYPE_CHECKING:
    from distributed import Client
    from distributed import Future as Remote


Arguments = ParamSpec("Arguments")
Result = TypeVar("Result")

CONNECTING_S = 15.0


class DaskEngine:
    """The workers of a scheduler; each of their threads takes one job at a time."""

    def __init__(self, address: str, settings: Settings, *, shares_files: bool) -> None:
        """Raises InputError `cluster_unreachable`, `cluster_empty` and `cluster_version`, ServiceError
        `cluster_unavailable` without the extra."""
        self._client = _connected(address)
        self._settings = settings
        self._shares_files = shares_files
        self.places = sum(self._client.nthreads().values())
        if not self.places:
            self.close()
            raise InputError("cluster_empty", f"{address}: the scheduler has no workers; start some", field="scheduler")
        _require_same_version(self._client, address)

    def submit(self, job: LineJob) -> Future[LineOutcome]:
        if self._shares_files:
            return self.call(perform_in_worker, job, self._settings)
        try:
            return self.call(perform_in_worker, sent(job), self._settings)
        except InputError as error:
            return failed_to_send(job, error)

    def learn(self, job: ReferenceJob) -> Future[SpeakerReference | None]:
        return self.call(learn_in_worker, job if self._shares_files else voice_sent(job), self._settings)

    def call(
        self, work: Callable[Arguments, Result], *args: Arguments.args, **kwargs: Arguments.kwargs
    ) -> Future[Result]:
        """The result or error of `work` in a worker; `WorkerDiedError` if the worker dies during it."""
        done: Future[Result] = Future()
        remote = self._client.submit(work, *args, **kwargs, pure=False)
        remote.add_done_callback(lambda ended: _tell(ended, done))
        return done

    def close(self) -> None:
        self._client.close()


def _connected(address: str) -> Client:
    try:
        from distributed import Client
    except ModuleNotFoundError:
        message = "a cluster needs dask, which is not installed: pip install '.[cluster]'"
        raise ServiceError("cluster_unavailable", message) from None
    try:
        return Client(address, timeout=CONNECTING_S, set_as_default=False)
    except (OSError, TimeoutError, ValueError) as error:
        message = f"{address}: no dask scheduler answers there ({error}); give tcp://HOST:PORT"
        raise InputError("cluster_unreachable", message, field="scheduler") from None


def _require_same_version(client: Client, address: str) -> None:
    """Raises InputError `cluster_version` where workers have another version, whose results may differ."""
    try:
        versions = client.run(version_in_worker)
    except (ImportError, AttributeError) as error:
        message = f"{address}: understudy is not installed on all workers ({error}); install {__version__} there"
        raise InputError("cluster_version", message, field="scheduler") from None
    others = {f"{worker} has {version}" for worker, version in versions.items() if version != __version__}
    if others:
        message = f"{address}: {', '.join(sorted(others))}, this is {__version__}; install the same everywhere"
        raise InputError("cluster_version", message, field="scheduler")


def _tell(ended: Remote, done: Future[Result]) -> None:
    from distributed import KilledWorker

    if ended.cancelled():
        done.set_exception(ServiceError("cluster_lost", "the scheduler has lost the line"))
        return
    error = ended.exception()
    if isinstance(error, KilledWorker):
        done.set_exception(WorkerDiedError(str(error)))
    elif error is not None:
        done.set_exception(error)
    else:
        done.set_result(ended.result())


def sent(job: LineJob) -> LineJob:
    """The job with its recording. Raises InputError when that cannot be read."""
    return replace(job, audio=job.audio.to_send(), folder=None)


def voice_sent(job: ReferenceJob) -> ReferenceJob:
    """The job with its recordings. Those that cannot be read are left out; their own lines report why."""
    found = []
    for recording in job.recordings:
        try:
            found.append(recording.to_send())
        except InputError:
            continue
    return replace(job, recordings=tuple(found))


def failed_to_send(job: LineJob, error: InputError) -> Future[LineOutcome]:
    """The outcome of a line whose recording cannot be read."""
    done: Future[LineOutcome] = Future()
    done.set_result(LineOutcome(job.id, 0.0, failure=Failure.of(error)))
    return done
