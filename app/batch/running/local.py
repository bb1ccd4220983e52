"""The engine on this machine: worker processes that each load the models once, with one call at a time.

Every worker is a pool of one process. So it is always known during which call a worker died, only that call is lost,
and the next one gets a new worker; pools of several processes (concurrent.futures, loky, joblib) lose everything
pending when one dies (docs/references.md: 187 of 200 jobs).

A worker ends with the process that started it, however that ends, and ignores Ctrl-C.
"""

import multiprocessing
import os
import signal
import threading
from collections.abc import Callable
from concurrent.futures import Future, ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from queue import SimpleQueue
from typing import ParamSpec, TypeVar

from ...model.voice.signal import SpeakerReference
from ...settings import Settings
from ..work.jobs import LineJob, LineOutcome, ReferenceJob
from ..work.worker import learn_in_worker, perform_in_worker
from .engine import WorkerDiedError

Arguments = ParamSpec("Arguments")
Result = TypeVar("Result")


class Processes:
    """A number of workers; each is started by its first call."""

    def __init__(self, workers: int) -> None:
        self.workers = workers
        self._idle: SimpleQueue[ProcessPoolExecutor] = SimpleQueue()
        self._pools: set[ProcessPoolExecutor] = set()
        for _ in range(workers):
            self._add_worker()

    def call(
        self, work: Callable[Arguments, Result], *args: Arguments.args, **kwargs: Arguments.kwargs
    ) -> "Future[Result]":
        """The result or error of `work` in an idle worker, waiting for one if necessary; `WorkerDiedError` if it
        dies."""
        pool = self._idle.get()
        done: Future[Result] = Future()
        running = pool.submit(work, *args, **kwargs)
        running.add_done_callback(lambda ended: self._tell(pool, ended, done))
        return done

    def close(self) -> None:
        """Aborts whatever is running."""
        for pool in list(self._pools):
            self._end(pool)

    def _tell(self, pool: ProcessPoolExecutor, ended: "Future[Result]", done: "Future[Result]") -> None:
        """Frees the worker before the result is set, so that the next call finds it idle."""
        error = WorkerDiedError("closed") if ended.cancelled() else ended.exception()
        if isinstance(error, BrokenProcessPool):
            self._end(pool)
            self._add_worker()
            error = WorkerDiedError("the worker's process ended")
        else:
            self._idle.put(pool)
        if error is not None:
            done.set_exception(error)
        else:
            done.set_result(ended.result())

    def _add_worker(self) -> None:
        pool = ProcessPoolExecutor(1, mp_context=multiprocessing.get_context("spawn"), initializer=_begin_worker)
        self._pools.add(pool)
        self._idle.put(pool)

    def _end(self, pool: ProcessPoolExecutor) -> None:
        self._pools.discard(pool)
        processes = list(
            (pool._processes or {}).values()
        )  # before Python 3.14 there is no public way to abort running calls
        pool.shutdown(wait=False, cancel_futures=True)
        for process in processes:
            process.kill()


def _begin_worker() -> None:
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    parent = multiprocessing.parent_process()
    if parent is not None:
        threading.Thread(target=_end_after, args=(parent.join,), daemon=True).start()


def _end_after(wait: Callable[[], None]) -> None:
    wait()
    os._exit(1)


class LocalEngine:
    """Workers that read recordings and write outputs themselves."""

    def __init__(self, workers: int, settings: Settings) -> None:
        self._processes = Processes(workers)
        self._settings = settings

    @property
    def places(self) -> int:
        return self._processes.workers

    def submit(self, job: LineJob) -> "Future[LineOutcome]":
        return self._processes.call(perform_in_worker, job, self._settings)

    def learn(self, job: ReferenceJob) -> "Future[SpeakerReference | None]":
        return self._processes.call(learn_in_worker, job, self._settings)

    def close(self) -> None:
        self._processes.close()
