"""Places, queue, deadlines, and no job lost whatever happens to the processes. The processes are real."""

import asyncio
import math
import os
import signal
from collections.abc import AsyncIterator, Awaitable, Callable
from contextlib import asynccontextmanager
from typing import Any

import psutil
import pytest

from tests.support.jobs import LONG, LONG_BML, SHORT, SHORT_TEXT
from understudy.api.workers import pool as pool_module
from understudy.api.workers.limits import Deadline
from understudy.api.workers.messages import Answer
from understudy.api.workers.nursery import IDLE_S
from understudy.api.workers.places import Places
from understudy.api.workers.pool import JOBS_A_WORKER, NOBODY, Pool
from understudy.api.workers.processes import Nursery
from understudy.api.workers.turns import Caller, Turns
from understudy.errors import InputError, ServiceError, TooLargeError, UnderstudyError
from understudy.settings import Settings

PATIENCE_S = 60.0
TOO_LITTLE_BYTES = 24 * 1024 * 1024
"""Memory beyond a worker's own that a short job does not need and the answer to a long one, 11 MB and all that is made
on the way to it, cannot do with."""


@asynccontextmanager
async def _pool(nursery: Nursery, *, jobs_each: int = JOBS_A_WORKER, **settings: Any) -> AsyncIterator[Pool]:  # noqa: ANN401
    whole = Settings(**({"workers": 1, "queue_s": 3 * PATIENCE_S} | settings))
    async with Pool(nursery, whole, jobs_each=jobs_each) as pool:
        yield pool


async def _until(holds: Callable[[], bool]) -> None:
    for _ in range(int(PATIENCE_S / 0.01)):
        if holds():
            return
        await asyncio.sleep(0.01)
    raise AssertionError("it never came about")


def _children(pool: Pool) -> set[int]:
    """The workers: all that the nursery has forked but the one that would take its place."""
    return {child.pid for child in psutil.Process(pool.nursery.pid).children()} - {pool.nursery.next_pid}


def _is_running(pid: int) -> bool:
    """Whether a process is there and has not ended, whether or not its parent knows."""
    try:
        return psutil.Process(pid).status() != psutil.STATUS_ZOMBIE
    except psutil.NoSuchProcess:
        return False


async def _begun(pool: Pool) -> "asyncio.Task[Any]":
    """A long job that is being done."""
    busy = pool.busy
    running = asyncio.create_task(pool.run(LONG, LONG_BML, Deadline.starting_now(PATIENCE_S)))
    await _until(lambda: pool.busy > busy)
    return running


async def _short(pool: Pool, caller: Caller = NOBODY) -> Answer:
    answer, body = await pool.run(SHORT, SHORT_TEXT, Deadline.starting_now(PATIENCE_S * 3), caller)
    assert b"negation" in body
    return answer


async def _code(waiting: Awaitable[object]) -> str:
    with pytest.raises(UnderstudyError) as caught:
        await waiting
    return caught.value.code


def test_jobs_past_the_queue_are_told_when_to_come_again_and_the_rest_wait(nursery: Nursery) -> None:
    async def scenario() -> None:
        async with _pool(nursery, queue=1) as pool:
            first = await _begun(pool)
            second = asyncio.create_task(_short(pool))
            await _until(lambda: pool.waiting == 1)
            with pytest.raises(ServiceError) as caught:
                await _short(pool)
            assert caught.value.code == "service_full"
            assert caught.value.retry_after_s
            first.cancel()
            assert (await second).media_type == "application/json"

    asyncio.run(scenario())


def test_who_comes_again_when_told_is_served_though_others_renew_their_names(nursery: Nursery) -> None:
    """They keep the queue full, under another name each time; all at its places are of one address."""

    async def scenario() -> None:
        now_s = [0.0]
        async with _pool(nursery, queue=2) as pool:
            pool._places = Places(2, Turns(lambda: now_s[0]), lambda: now_s[0])
            running = await _begun(pool)
            waiting = [asyncio.create_task(_short(pool, Caller("address", str(n))), name=str(n)) for n in range(2)]
            await _until(lambda: pool.waiting == 2)
            told = Caller("told", "its only name")
            with pytest.raises(ServiceError) as caught:
                pool.require_place(told)
            assert caught.value.retry_after_s
            now_s[0] = math.ceil(caught.value.retry_after_s)
            for newcomer in (Caller("address", "3"), Caller("newcomer", "1")):
                with pytest.raises(ServiceError):
                    pool.require_place(newcomer)
            order = list[str]()
            served = asyncio.create_task(_short(pool, told), name="told")
            for task in (served, *waiting):
                task.add_done_callback(lambda done: order.append(done.get_name()))
            await _until(lambda: pool.waiting == 3)
            running.cancel()
            await asyncio.gather(served, *waiting)
            assert order == ["0", "told", "1"]

    asyncio.run(scenario())


async def _has_next(pool: Pool) -> int:
    """The process that would take the nursery's place, once there is one."""
    await _until(lambda: pool.nursery.next_pid is not None)
    return pool.nursery.next_pid or 0


def test_a_nursery_that_was_killed_is_renewed_though_nobody_needs_it(
    nursery: Nursery, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Here from nothing, for nothing was forked to take its place. What is wrong is told meanwhile. The worker that is
    forked at once is replaced by one that is warm, and there is always one."""
    monkeypatch.setattr(pool_module, "_COLD_FOR_S", 2 * IDLE_S)
    seen = set()

    def are_warm(pool: Pool) -> list[bool]:
        warm = [worker.is_warm for worker in pool._workers()]
        seen.add(len(warm))
        return warm

    async def scenario(own: Nursery) -> None:
        async with _pool(own) as pool:
            _kill(pool, and_its_nursery_by=signal.SIGKILL)
            while "forks" not in (await pool.trouble() or ""):
                await asyncio.sleep(0.01)
            await _until(lambda: pool.nursery is not own)
            await _short(pool)
            assert await pool.trouble() is None
            assert are_warm(pool) == [False]
            await _until(lambda: are_warm(pool) == [True])
            assert seen == {1}
            await _short(pool)

    with nursery.divided() as own:
        asyncio.run(scenario(own))


def test_another_takes_the_place_of_one_that_was_killed_or_hangs_at_once_and_again(nursery: Nursery) -> None:
    async def scenario(own: Nursery) -> None:
        async with _pool(own) as pool:
            for number in (signal.SIGKILL, signal.SIGSTOP, signal.SIGKILL):
                failed, following = pool.nursery, await _has_next(pool)
                _kill(pool, and_its_nursery_by=number)
                await _until(lambda failed=failed: pool.nursery is not failed)  # type: ignore[misc]
                assert pool.nursery.pid == following
                await _short(pool)
            assert not _is_running(failed.pid)

    with nursery.divided() as own:
        asyncio.run(scenario(own))


def test_one_that_was_killed_itself_takes_nobody_s_place(nursery: Nursery) -> None:
    with nursery.divided() as own:
        own.require_next()
        first = own.next_pid
        assert first
        os.kill(first, signal.SIGKILL)
        while _is_running(first):
            pass
        own.require_next()
        assert own.next_pid not in (None, first)


def test_a_nursery_ends_with_those_that_would_take_its_place(nursery: Nursery) -> None:
    with nursery.divided() as own:
        own.require_next()
        assert own.next_pid
        family = [psutil.Process(pid) for pid in (own.pid, own.next_pid)]
    _gone, alive = psutil.wait_procs(family, PATIENCE_S)
    assert alive == []


def test_one_that_rests_ends_with_a_service_that_was_killed(nursery: Nursery) -> None:
    """Nobody kills it then; its socket is closed."""
    with nursery.divided() as own:
        process = psutil.Process(own.pid)
        own._control.close()
        _gone, alive = psutil.wait_procs([process], PATIENCE_S)
        assert alive == []


def test_waiting_ends(nursery: Nursery) -> None:
    async def scenario() -> None:
        async with _pool(nursery, queue_s=0.05) as pool:
            first = await _begun(pool)
            assert await _code(_short(pool)) == "service_full"
            assert pool.waiting == 0
            first.cancel()

    asyncio.run(scenario())


def test_a_job_past_its_deadline_or_without_its_client_is_stopped_and_its_place_free(nursery: Nursery) -> None:
    async def scenario() -> None:
        async with _pool(nursery) as pool:
            before = _children(pool)
            assert await _code(pool.run(LONG, LONG_BML, Deadline.starting_now(0.1))) == "deadline_passed"
            await _short(pool)
            left = await _begun(pool)
            left.cancel()
            await _short(pool)
            await _until(lambda: not before & _children(pool))

    asyncio.run(scenario())


def test_an_error_of_the_job_comes_out_and_its_worker_goes_on(nursery: Nursery) -> None:
    async def scenario() -> None:
        async with _pool(nursery) as pool:
            before = _children(pool)
            with pytest.raises(InputError) as caught:
                await pool.run(SHORT, b'{"text": ""}', Deadline.starting_now(PATIENCE_S))
            assert (caught.value.code, caught.value.field) == ("text_empty", "text")
            assert _children(pool) == before

    asyncio.run(scenario())


def _kill(pool: Pool, *, and_its_nursery_by: signal.Signals | None = None) -> None:
    """Kills the workers. The nursery goes first, but is asked for them while it lives."""
    workers = _children(pool)
    if and_its_nursery_by is not None:
        os.kill(pool.nursery.pid, and_its_nursery_by)
    for pid in workers:
        os.kill(pid, signal.SIGKILL)


def test_a_worker_that_is_killed_is_replaced_and_its_job_done_by_another(nursery: Nursery) -> None:
    async def scenario() -> None:
        async with _pool(nursery) as pool:
            _kill(pool)
            await _short(pool)
            running = await _begun(pool)
            _kill(pool)
            answer, body = await running
            assert answer.media_type == "application/json"
            assert body.startswith(b"{")

    asyncio.run(scenario())


def test_workers_that_were_killed_while_idle_lose_no_job(nursery: Nursery) -> None:
    async def scenario() -> None:
        async with _pool(nursery, workers=2) as pool:
            killed = _children(pool)
            for child in killed:
                os.kill(child, signal.SIGKILL)
            await _until(lambda: all(worker.has_ended for worker in pool._idle))
            await _short(pool)

    asyncio.run(scenario())


def test_a_job_that_loses_two_workers_is_given_up(nursery: Nursery) -> None:
    async def scenario() -> None:
        async with _pool(nursery) as pool:
            running = await _begun(pool)
            first = _children(pool)
            _kill(pool)
            await _until(lambda: pool.busy == 1 and bool(_children(pool) - first))
            _kill(pool)
            assert await _code(running) == "worker_lost"
            await _short(pool)

    asyncio.run(scenario())


def test_a_stopped_aligner_is_told_of_and_replaced(nursery: Nursery) -> None:
    async def scenario() -> None:
        async with _pool(nursery) as pool:
            [worker] = [psutil.Process(pid) for pid in _children(pool)]
            await _until(lambda: len(worker.children()) == 1)
            [aligner] = worker.children()
            aligner.suspend()
            while not (told := await pool.trouble()):
                await asyncio.sleep(0)
            assert "worker" in told
            await _until(lambda: not _is_running(aligner.pid))
            await _short(pool)
            assert await pool.trouble() is None

    asyncio.run(scenario())


def test_a_job_may_take_only_so_much_memory(nursery: Nursery) -> None:
    async def scenario() -> None:
        async with _pool(nursery, worker_memory_bytes=TOO_LITTLE_BYTES) as pool:
            with pytest.raises(TooLargeError) as caught:
                await pool.run(LONG, LONG_BML, Deadline.starting_now(PATIENCE_S))
            assert caught.value.code == "work_too_large"
            await _short(pool)

    asyncio.run(scenario())


def test_a_worker_is_replaced_after_so_many_jobs(nursery: Nursery) -> None:
    async def scenario() -> None:
        async with _pool(nursery, jobs_each=2) as pool:
            before = _children(pool)
            await _short(pool)
            assert _children(pool) == before
            await _short(pool)
            await _short(pool)
            await _until(lambda: not before & _children(pool))

    asyncio.run(scenario())


def test_when_the_service_stops_what_runs_has_its_grace(nursery: Nursery) -> None:
    async def scenario() -> None:
        async with _pool(nursery) as pool:
            running = await _begun(pool)
            stopping = asyncio.create_task(pool.stop(0.2))
            await asyncio.sleep(0)
            assert await _code(_short(pool)) == "service_stopping"
            assert "stopping" in (await pool.trouble() or "")
            assert await _code(running) == "service_stopping"
            await stopping

    asyncio.run(scenario())
