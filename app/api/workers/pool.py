"""The pool of workers, with a short queue (`Places`), and the replacement of workers that hang or die.

A job that exceeds its deadline, whose client has gone, or that runs when the service stops is cancelled by killing its
worker; another is forked. If a worker is lost through no fault of its job (killed, its aligner stopped), the job, which
has no side effects, is retried once on another.
"""

import asyncio
import logging
import time
from collections import deque
from collections.abc import Iterable
from contextlib import suppress
from typing import Self

from ...errors import ServiceError, UnderstudyError
from ...settings import Settings
from .limits import Deadline, too_large
from .messages import Answer, Content, Job, JobFailure
from .places import Places
from .processes import Nursery, Worker, WorkerLostError, WorkerState, is_stopped, look, wait_until_gone
from .turns import Caller, Refusals, ServiceTimes

_LOGGER = logging.getLogger(__name__)
JOBS_A_WORKER = 1000
"""After so many jobs a worker is replaced by a new one."""

_WATCH_EVERY_S = 0.5
_FORK_WITHIN_S = 60.0
"""On a busy machine too; processes that hang are noticed sooner, by the watch."""

_COLD_FOR_S = 5.0
"""A worker that is not warm is replaced after so long, when it is idle and another has been forked for it: a nursery
that is warming up forks none meanwhile."""

_AGAIN_AFTER_S = 0.5
_RETRIES = 1
_LOST = frozenset({"aligner_crashed"})
"""Error codes that are the worker's fault, not its job's."""

_SPENT = frozenset({"work_too_large"})
"""Error codes after which a worker is replaced, because its memory may not be free for the next job."""

NOBODY = Caller()


class Pool:
    """Runs jobs in worker processes. Belongs to the event loop that entered it."""

    def __init__(self, nursery: Nursery, settings: Settings, *, jobs_each: int = JOBS_A_WORKER) -> None:
        """The caller closes the nursery; replacements of it are closed here."""
        self._jobs_each = jobs_each
        self.nursery = self._given = nursery
        self._settings = settings
        self._idle: deque[Worker] = deque()
        self._busy: set[Worker] = set()
        self._places = Places[Worker](settings.queue_length)
        self.refusals = Refusals()
        self._making: set[asyncio.Task[None]] = set()
        self._running: set[asyncio.Task[tuple[Answer, bytearray]]] = set()
        self._retired: set[int] = set()
        self._times = ServiceTimes()
        self._renewing: asyncio.Task[None] | None = None
        self._dividing: asyncio.Task[None] | None = None
        self._relieving: asyncio.Task[None] | None = None
        self._watch: asyncio.Task[None] | None = None
        self._seen: tuple[WorkerState, ...] = ()
        self._is_stopping = False
        self._is_closed = False

    async def __aenter__(self) -> Self:
        for _ in range(self._settings.worker_count):
            self._make()
        await asyncio.gather(*self._making)
        self._watch = asyncio.create_task(self._keep_watch())
        return self

    async def __aexit__(self, *_exception: object) -> None:
        self._is_closed = True
        await self.stop(0.0)
        ending = [task for task in (self._watch, self._relieving, *self._making) if task is not None]
        for task in ending:
            task.cancel()
        await asyncio.gather(*ending, return_exceptions=True)
        await asyncio.gather(*(task for task in (self._renewing, self._dividing) if task is not None))
        workers = list(self._workers())
        for worker in workers:
            worker.end()
        if self.nursery is not self._given:
            self.nursery.close()
        wait_until_gone(workers)

    @property
    def busy(self) -> int:
        """The number of running jobs."""
        return len(self._busy)

    @property
    def waiting(self) -> int:
        """The number of jobs that wait for a worker."""
        return len(self._places)

    @property
    def _missing(self) -> int:
        """The number of workers being started, whose jobs wait again without taking a place in the queue."""
        return max(self._settings.worker_count - len(self._idle) - len(self._busy), 0)

    @property
    def retry_after_s(self) -> float:
        """An estimate of when all current jobs will be done, from recent durations."""
        return self._times.mean_s * (self.busy + self.waiting) / self._settings.worker_count

    def require_place(self, caller: Caller = NOBODY) -> None:
        """Raises ServiceError `service_full` if this caller's job may not wait, `service_stopping`."""
        if self._is_stopping:
            raise _stopping()
        if not self._places.has_room(caller, self._missing) and not self._idle:
            raise self._full(caller)

    async def trouble(self) -> str | None:
        """Why the pool is not ready; None when it is."""
        if self._is_stopping:
            return "the service is stopping"
        await self._look()
        stopped = [each.trouble for each in self._seen if each.trouble]
        if self._renewing is not None:
            stopped.append("the process that forks workers is being started again")
        if self._missing:
            stopped.append(f"{self._missing} of {self._settings.worker_count} workers are being started")
        return "; ".join(stopped) or None

    async def run(
        self, job: Job, content: Content, deadline: Deadline, caller: Caller = NOBODY
    ) -> tuple[Answer, bytearray]:
        """The answer to a job, and its body. Cancelling this stops the job.

        Raises the job's error, and ServiceError: `service_full`, `service_stopping`, `deadline_passed`,
        `worker_lost`.
        """
        self.require_place(caller)
        self._places.turns.take(caller)
        task = asyncio.create_task(self._tried(job, content, caller))
        self._running.add(task)
        task.add_done_callback(self._running.discard)
        try:
            await asyncio.wait({task}, timeout=deadline.remaining_s)
            if not task.done():
                raise deadline.passed()
            if task.cancelled():
                raise _stopping()
            return task.result()
        finally:
            task.cancel()

    async def stop(self, grace_s: float) -> None:
        """Refuses new jobs, and returns when all others are done; after `grace_s` they are stopped."""
        self._is_stopping = True
        if self._running:
            await asyncio.wait(self._running, timeout=grace_s)
        for task in list(self._running):
            task.cancel()
        await asyncio.gather(*self._running, return_exceptions=True)

    async def replace_all(self) -> None:
        """Replaces every worker, the busy ones when they are done."""
        await asyncio.gather(*self._making)
        self._retired |= {worker.process.pid for worker in self._busy}
        while self._idle:
            self._dismiss(self._idle.pop())

    async def _tried(self, job: Job, content: Content, caller: Caller) -> tuple[Answer, bytearray]:
        for _ in range(1 + _RETRIES):
            with suppress(WorkerLostError):
                return await self._done(job, content, caller)
            _LOGGER.warning("a worker was lost while it worked")
        raise ServiceError("worker_lost", "the worker process ended; try again", retry_after_s=self.retry_after_s)

    async def _done(self, job: Job, content: Content, caller: Caller) -> tuple[Answer, bytearray]:
        worker = await self._taken(caller)
        began_s = asyncio.get_running_loop().time()
        try:
            answer, body = await worker.answer(job, content)
        except BaseException:
            self._busy.discard(worker)
            self._dismiss(worker)
            raise
        self._times.add(asyncio.get_running_loop().time() - began_s)
        code = answer.error.code if isinstance(answer, JobFailure) else None
        self._give_back(worker, is_spent=code in _SPENT)
        if isinstance(answer, Answer):
            return answer, body
        if code in _LOST:
            raise WorkerLostError
        raise answer.error

    async def _taken(self, caller: Caller) -> Worker:
        """A free worker. Raises ServiceError `service_full` after waiting too long."""
        while self._idle and self._idle[0].has_ended:
            self._dismiss(self._idle.popleft())
        worker = await self._queued(caller) if self._places or not self._idle else self._idle.popleft()
        self._busy.add(worker)
        return worker

    async def _queued(self, caller: Caller) -> Worker:
        with self._places.place(caller.client) as given:
            try:
                async with asyncio.timeout(self._settings.queue_s):
                    return await given
            except BaseException as error:
                if given.done() and not given.cancelled():
                    self._busy.discard(given.result())
                    self._offer(given.result())
                if isinstance(error, TimeoutError):
                    raise self._full(caller) from None
                raise

    def _give_back(self, worker: Worker, *, is_spent: bool) -> None:
        self._busy.discard(worker)
        if is_spent or worker.jobs >= self._jobs_each or worker.process.pid in self._retired:
            self._dismiss(worker)
        else:
            self._offer(worker)

    def _offer(self, worker: Worker) -> None:
        """Gives the worker to the job that is next, or marks it idle: who worked last is first, for it may know the
        next job's line (`KnownLines`)."""
        given = self._places.next()
        if given is None:
            self._idle.appendleft(worker)
        else:
            self._busy.add(worker)
            given.set_result(worker)

    def _dismiss(self, worker: Worker) -> None:
        """Ends a worker and starts another."""
        self._retired.discard(worker.process.pid)
        worker.end()
        self._make()

    def _make(self) -> None:
        if self._is_closed:
            return
        task = asyncio.create_task(self._made())
        self._making.add(task)
        task.add_done_callback(self._making.discard)

    async def _made(self) -> None:
        self._offer(await self.forked())

    async def forked(self, *, is_live: bool = False) -> Worker:
        """A new worker; a nursery that has ended or hangs is replaced first."""
        while True:
            nursery = self.nursery
            try:
                async with asyncio.timeout(_FORK_WITHIN_S):
                    return await Worker.forked(nursery, self._settings, is_live=is_live)
            except (OSError, EOFError, TimeoutError):
                await self._renewed(nursery)

    async def _renewed(self, failed: Nursery) -> None:
        """Waits until the failed nursery is replaced. Cancelling one waiter does not cancel the replacement."""
        self._renew_soon(failed)
        if self._renewing is not None:
            await asyncio.shield(self._renewing)

    def _renew_soon(self, failed: Nursery) -> None:
        if failed is self.nursery and self._renewing is None:
            self._renewing = asyncio.create_task(self._renew(failed))

    async def _renew(self, failed: Nursery) -> None:
        _LOGGER.warning("the process that forks workers has ended or hangs; it is started again")
        try:
            self.nursery = await asyncio.to_thread(failed.again)
        except UnderstudyError as error:
            _LOGGER.error("%s", error.message)
            await asyncio.sleep(_AGAIN_AFTER_S)
        finally:
            self._renewing = None

    def _full(self, caller: Caller) -> ServiceError:
        message = f"{self.busy} requests are being processed and {self.waiting} wait; try again later"
        again_after_s = max(self.retry_after_s, self._times.mean_s)
        self._places.turns.keep(caller, again_after_s)
        return ServiceError("service_full", message, retry_after_s=again_after_s)

    async def _keep_watch(self) -> None:
        while True:
            await asyncio.sleep(_WATCH_EVERY_S)
            await self._look()

    async def _look(self) -> None:
        """Replaces a nursery that ended or hangs and workers that died idle; kills stopped workers and those with too
        much memory."""
        jobs = {worker: worker.jobs for worker in self._workers()}
        nursery = self.nursery
        self._seen = await asyncio.to_thread(look, tuple(jobs), self._settings.worker_memory_bytes)
        hangs = await asyncio.to_thread(is_stopped, nursery.pid)
        if not self._is_closed:
            self._look_after(nursery, is_well=not hangs and not nursery.has_ended)
        for seen in self._seen:
            if seen.is_too_large and seen.worker.jobs == jobs[seen.worker]:  # else its job is another by now
                seen.worker.given_up = too_large(self._settings.worker_memory_bytes)
            if seen.trouble and seen.worker in self._idle:
                self._idle.remove(seen.worker)
                self._dismiss(seen.worker)
            elif seen.trouble and seen.worker in self._busy:
                seen.worker.kill()
        if not self._missing and (self._relieving is None or self._relieving.done()):
            self._replace_cold()

    def _replace_cold(self) -> None:
        """Replaces one worker that would load for its next job what others have inherited."""
        late_s = time.monotonic() - _COLD_FOR_S
        cold = next((each for each in self._idle if not each.is_warm and each.began_s < late_s), None)
        if cold is not None:
            self._relieving = asyncio.create_task(self._relieve(cold))

    async def _relieve(self, cold: Worker) -> None:
        """Ends a worker once another is there for it, unless it has found work meanwhile."""
        warm = await self.forked()
        if cold in self._idle and not self._is_closed:
            self._idle.remove(cold)
            cold.end()
            self._offer(warm)
        else:
            warm.end()

    def _look_after(self, nursery: Nursery, *, is_well: bool) -> None:
        """Replaces a nursery that is not well; for one that is sees to it that another can take its place."""
        if not is_well:
            self._renew_soon(nursery)
        elif self._dividing is None or self._dividing.done():
            self._dividing = asyncio.create_task(asyncio.to_thread(nursery.require_next))

    def _workers(self) -> Iterable[Worker]:
        yield from self._idle
        yield from self._busy


def _stopping() -> ServiceError:
    return ServiceError("service_stopping", "the service is stopping; try again in a moment", retry_after_s=5.0)
