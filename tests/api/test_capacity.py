"""So much at a time, each until its deadline, and no place lost on the way."""

import asyncio
import threading
import time
from collections.abc import Callable

import pytest

from understudy.api.capacity import Capacity, Deadline
from understudy.errors import InputError, ServiceError
from understudy.performance import Progress


async def _until(condition: Callable[[], bool]) -> None:
    for _ in range(500):
        if condition():
            return
        await asyncio.sleep(0.01)
    raise AssertionError("it never came about")


def test_work_past_the_places_is_refused_and_places_come_back() -> None:
    async def scenario() -> None:
        capacity, gate = Capacity(2), threading.Event()
        running = [asyncio.create_task(capacity.run(lambda _: gate.wait(5), Deadline.starting_now(5))) for _ in "12"]
        await _until(lambda: capacity.is_full)
        with pytest.raises(ServiceError) as caught:
            await capacity.run(lambda _: None, Deadline.starting_now(5))
        assert caught.value.code == "service_full"
        gate.set()
        assert await asyncio.gather(*running) == [True, True]
        assert await capacity.run(lambda _: "again", Deadline.starting_now(5)) == "again"
        capacity.close()

    asyncio.run(scenario())


def test_late_work_is_answered_at_once_but_keeps_its_place_until_its_next_stage() -> None:
    async def scenario() -> None:
        capacity, gate = Capacity(1), threading.Event()
        stages: list[str] = []

        def work(progress: Progress) -> None:
            gate.wait(5)
            progress("parse")
            stages.append("parse")

        with pytest.raises(ServiceError) as caught:
            await capacity.run(work, Deadline.starting_now(0.05))
        assert caught.value.code == "deadline_passed"
        assert capacity.is_full
        gate.set()
        await _until(lambda: not capacity.is_full)
        assert stages == []
        capacity.close()

    asyncio.run(scenario())


def test_an_error_of_the_work_comes_out_and_frees_its_place() -> None:
    async def scenario() -> None:
        capacity = Capacity(1)

        def work(_progress: Progress) -> None:
            raise InputError("text_empty", "no words")

        for _ in "12":
            with pytest.raises(InputError):
                await capacity.run(work, Deadline.starting_now(5))
        assert not capacity.is_full
        capacity.close()

    asyncio.run(scenario())


def test_a_cancelled_request_keeps_its_place_while_its_thread_runs() -> None:
    async def scenario() -> None:
        capacity, gate = Capacity(1), threading.Event()
        request = asyncio.create_task(capacity.run(lambda _: gate.wait(5), Deadline.starting_now(5)))
        await _until(lambda: capacity.is_full)
        request.cancel()
        with pytest.raises(asyncio.CancelledError):
            await request
        assert capacity.is_full
        gate.set()
        await _until(lambda: not capacity.is_full)
        capacity.close()

    asyncio.run(scenario())


def test_waiting_ends_with_the_deadline() -> None:
    async def scenario() -> None:
        began = time.monotonic()
        with pytest.raises(ServiceError) as caught:
            await Deadline.starting_now(0.05).within(asyncio.sleep(5))
        assert caught.value.code == "deadline_passed"
        assert time.monotonic() - began < 2

    asyncio.run(scenario())
