"""What waits for a slow reader: the newest frames, with how many were left out, and everything else."""

import asyncio
import json

import pytest

from understudy.api.outgoing_queue import MOST_FRAMES, MOST_OTHERS, OutgoingQueue
from understudy.api.workers.messages import LiveOutput

FRAMES, OTHER, LAST = LiveOutput(False, True), LiveOutput(False, False), LiveOutput(True, False)
PER_OUTPUT = 3


def frames(number: int) -> str:
    return "\n".join([f"frame {number}"] * PER_OUTPUT)


async def taken(unsent: OutgoingQueue) -> list[str]:
    """All that is told, up to the last."""
    lines: list[str] = []
    while True:
        output, told = await unsent.take()
        lines += told.splitlines()
        if output.ended:
            return lines


def test_nothing_is_left_out_while_there_is_room() -> None:
    async def run() -> list[str]:
        unsent = OutgoingQueue()
        for number in range(MOST_FRAMES):
            await unsent.put(FRAMES, frames(number))
        await unsent.put(LAST, "done")
        return await taken(unsent)

    told = asyncio.run(run())
    assert told == [line for number in range(MOST_FRAMES) for line in frames(number).splitlines()] + ["done"]


def test_the_newest_frames_are_kept_and_it_is_told_how_many_were_not() -> None:
    async def run() -> list[str]:
        unsent = OutgoingQueue()
        await unsent.put(OTHER, "gesture")
        for number in range(MOST_FRAMES + 1000):
            await unsent.put(FRAMES, frames(number))
        await unsent.put(LAST, "done")
        return await taken(unsent)

    skipped, gesture, *kept, done = asyncio.run(run())
    assert json.loads(skipped) == {"type": "frames_skipped", "count": 1000 * PER_OUTPUT}
    assert (gesture, done) == ("gesture", "done")
    assert kept[::PER_OUTPUT] == [f"frame {number}" for number in range(1000, 1000 + MOST_FRAMES)]


def test_what_was_told_to_be_left_out_is_not_told_again() -> None:
    async def run() -> list[str]:
        unsent = OutgoingQueue()
        for number in range(MOST_FRAMES + 1):
            await unsent.put(FRAMES, frames(number))
        await unsent.take()
        await unsent.put(LAST, "done")
        return await taken(unsent)

    assert not any("skipped" in line for line in asyncio.run(run()))


def test_all_else_waits_for_room_and_frames_do_not() -> None:
    async def run() -> None:
        unsent = OutgoingQueue()
        for number in range(MOST_OTHERS):
            await unsent.put(OTHER, f"gesture {number}")
        with pytest.raises(TimeoutError):
            await asyncio.wait_for(unsent.put(OTHER, "one too many"), 0.05)
        await unsent.put(FRAMES, frames(0))
        waiting = asyncio.create_task(unsent.put(LAST, "done"))
        told = await taken(unsent)
        await waiting
        assert told == [*(f"gesture {number}" for number in range(MOST_OTHERS)), *frames(0).splitlines(), "done"]

    asyncio.run(run())
