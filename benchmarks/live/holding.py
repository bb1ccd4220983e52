"""Robustness of live streams: long, many, slow, interrupted and invalid ones, with a service of its own.

    python -m benchmarks.live.holding [--hour SECONDS] [--streams N] [--together SECONDS] [--part NAME …]

- memory: one stream of SECONDS of sound (3600), with frames, sent as fast as it is taken, with words, interruptions and
  silences on the way: memory of its process, a minute in and at the end.
- together: N streams (16) with sound at its own pace for SECONDS (30): how late messages are at first and at last, each
  stream's processor time over its sound, `/healthz`.
- slow: a client that reads nothing, and one that reads a tenth of the time.
- garbage: random text and bytes as messages, streams broken off anywhere; then a stream as ever.
"""

import argparse
import asyncio
import json
import random
import time
from collections import Counter
from contextlib import AsyncExitStack, suppress
from dataclasses import dataclass, field

import numpy as np
import psutil
import requests
from websockets.asyncio.client import ClientConnection, connect
from websockets.exceptions import ConnectionClosed

from benchmarks.live.serving import CHUNK_S, START, chunk, newest, processor_s, service, stream
from understudy.model import FloatArray

WARM_S = 60.0
"""What is loaded when first needed, and what caches hold, is there by then."""

MOST_SENT_AHEAD_S = 2.0
"""How much sound may wait in buffers, so that memory is measured when so much has been heard, not sent."""

PARTS = ("memory", "together", "slow", "garbage")


async def memory(port: int, process: psutil.Process, sound_s: float) -> None:
    async with stream(port, frames=30) as connection:
        worker, reader, began_s = newest(process), _Reader(connection), time.monotonic()
        reading = asyncio.create_task(reader.read())
        seen, total = list[tuple[float, float, float]](), round(sound_s / CHUNK_S)
        for number in range(total):
            at_s = number * CHUNK_S
            while reader.heard_s < at_s - MOST_SENT_AHEAD_S and not reading.done():
                await asyncio.sleep(0.01)
            await connection.send(chunk(number))
            if number % 250 == 0:
                await connection.send(json.dumps({"type": "words", "text": "No, I have never seen those."}))
            if number % 700 == 699:
                await connection.send(json.dumps({"type": "interrupt"}))
            if number % (total // 60) == 0:
                used = worker.memory_full_info()
                seen.append((at_s, used.uss / 2**20, used.rss / 2**20))
        await connection.send(json.dumps({"type": "end"}))
        await reading
    wall_s = time.monotonic() - began_s
    print(f"memory: {sound_s:.0f} s of sound in {wall_s:.0f} s, {reader.count} messages; MB from a minute on:")
    report_memory(np.array([row for row in seen if row[0] >= WARM_S]))


class _Reader:
    """Reads all messages of a stream, and how much it had heard by the last, and by which they were late of a clock."""

    def __init__(self, connection: ClientConnection) -> None:
        self._connection, self._began_s = connection, time.monotonic()
        self.count, self.heard_s = 0, 0.0
        self.late_s: list[float] = []

    async def read(self) -> None:
        with suppress(ConnectionClosed):
            async for text in self._connection:
                told = json.loads(text)
                self.count += 1
                self.heard_s = told.get("heard_s", told.get("time_s", self.heard_s))
                self.late_s.append(time.monotonic() - self._began_s - self.heard_s)


def report_memory(settled: FloatArray) -> None:
    """Rows of when, own pages and all of them in MB."""
    for name, megabytes in (("own pages", settled[:, 1]), ("with shared ones", settled[:, 2])):
        quarters = [float(part.mean()) for part in np.array_split(megabytes, 4)]
        growth = 100 * (megabytes[-3:].mean() / megabytes[:3].mean() - 1)
        print(f"  {name}: {', '.join(f'{each:.1f}' for each in quarters)} by quarters, {growth:+.1f} % in all")


Opened = tuple[ClientConnection, psutil.Process]
"""A stream, and the process that has it."""


@dataclass(slots=True)
class Together:
    """What many streams at once have shown: how late messages came in the first and the last quarter of each, and the
    processor time of each over its sound; of frames at 60 and of events alone."""

    first_s: list[float] = field(default_factory=list)
    last_s: list[float] = field(default_factory=list)
    shares: dict[bool, list[float]] = field(default_factory=lambda: {False: [], True: []})


async def together(port: int, process: psutil.Process, streams: int, lasting_s: float) -> None:
    found, health_s = Together(), list[float]()
    probing = asyncio.create_task(_probe(port, health_s))
    async with AsyncExitStack() as stack:
        opened = list[Opened]()
        for number in range(streams):
            frames = 60 if number % 2 else None
            connection = await stack.enter_async_context(stream(port, frames=frames, seed=number))
            opened.append((connection, newest(process)))
        talking = (_talk(each, number, lasting_s, found) for number, each in enumerate(opened))
        await asyncio.gather(*talking)
    probing.cancel()
    print(f"together: {streams} streams (every second with frames at 60), {lasting_s:.0f} s of sound each")
    print(f"  messages late: first quarter {percentiles(found.first_s)}; last quarter {percentiles(found.last_s)}")
    for has_frames, shares in found.shares.items():
        name = "frames at 60" if has_frames else "events alone"
        print(f"  processor time, {name}: mean {np.mean(shares):.3f} ×, most {np.max(shares):.3f} ×")
    print(f"  /healthz {percentiles(health_s)}")


async def _talk(
    opened: tuple[ClientConnection, psutil.Process], number: int, lasting_s: float, found: Together
) -> None:
    """One stream at its own pace."""
    connection, worker = opened
    reader, before_s, began_s = _Reader(connection), processor_s(worker), time.monotonic()
    reading = asyncio.create_task(reader.read())
    for place in range(round(lasting_s / CHUNK_S)):
        await asyncio.sleep(max(0.0, began_s + (place + 1) * CHUNK_S - time.monotonic()))
        await connection.send(chunk(place + 31 * number))
    found.shares[number % 2 == 1].append((processor_s(worker) - before_s) / max(reader.heard_s, CHUNK_S))
    await connection.send(json.dumps({"type": "end"}))
    await reading
    quarter = len(reader.late_s) // 4
    found.first_s += reader.late_s[:quarter]
    found.last_s += reader.late_s[-quarter:]


async def _probe(port: int, health_s: list[float]) -> None:
    """Asks for `/healthz` five times a second."""
    while True:
        began_s = time.monotonic()
        await asyncio.to_thread(requests.get, f"http://127.0.0.1:{port}/healthz", timeout=10)
        health_s.append(time.monotonic() - began_s)
        await asyncio.sleep(0.2)


def percentiles(values: list[float]) -> str:
    median, most, longest = np.percentile(values, [50, 95, 100])
    return f"median {1000 * median:.0f} ms, p95 {1000 * most:.0f}, longest {1000 * longest:.0f}"


async def slow(port: int) -> None:
    await _unread(port)
    async with stream(port, frames=60) as connection:
        told = Counter[str]()
        for number in range(500):
            await connection.send(chunk(number))
            if number % 10 == 0:
                with suppress(TimeoutError):
                    for _ in range(5):
                        told.update([json.loads(await asyncio.wait_for(connection.recv(), 0.05))["type"]])
        await connection.send(json.dumps({"type": "end"}))
        with suppress(ConnectionClosed):
            async for text in connection:
                told.update([last := json.loads(text)["type"]])
    frames, others = told["frame"], told.total() - told["frame"]
    print(f"slow: a client that reads now and then got {frames} of 1200 frames and {others} other messages,")
    print(f"  the last {last}")


async def _unread(port: int) -> None:
    """A client that reads nothing."""
    async with connect(f"ws://127.0.0.1:{port}/live", max_queue=1, compression=None) as connection:
        await connection.send(json.dumps(START | {"frames": 60}))
        number, began_s = 0, time.monotonic()
        try:
            while time.monotonic() - began_s < 60:
                await asyncio.wait_for(connection.send(chunk(number)), 5)
                number += 1
            print("slow: a client that reads nothing was not let go within a minute")
        except (ConnectionClosed, TimeoutError) as error:
            how = type(error).__name__
            print(f"slow: a client that reads nothing was let go ({how}) after {number * CHUNK_S:.0f} s of sound")


async def garbage(port: int, process: psutil.Process) -> None:
    draw, codes = random.Random(0), Counter[str]()
    for _ in range(150):
        with suppress(ConnectionClosed, TimeoutError):
            await _send_garbage(port, draw, codes)
    await asyncio.sleep(1)
    left = len(process.children(recursive=True))
    async with stream(port) as connection:
        for number in range(100):
            await connection.send(chunk(number))
        await connection.send(json.dumps({"type": "end"}))
        async for text in connection:
            told = json.loads(text)
    print(f"garbage: 150 streams, errors {dict(sorted(codes.items()))};")
    print(f"  {left} processes are left; a stream after it: {told['type']}")


async def _send_garbage(port: int, draw: random.Random, codes: Counter[str]) -> None:
    """One stream, perhaps begun, perhaps broken off; counts the errors that it is told."""
    async with connect(f"ws://127.0.0.1:{port}/live", compression=None) as connection:
        if draw.random() < 0.6:
            await connection.send(json.dumps(START | {"frames": draw.choice([None, 30])}))
        for _ in range(draw.randrange(4)):
            await connection.send(_garbage(draw))
        if draw.random() < 0.3:
            connection.transport.abort()
        while True:
            told = json.loads(await asyncio.wait_for(connection.recv(), 0.3))
            codes.update([told["code"]] if told["type"] == "error" else [])


def _garbage(draw: random.Random) -> str | bytes:
    kinds = (
        lambda: draw.randbytes(draw.randrange(0, 4000)),
        lambda: "".join(chr(draw.randrange(1, 0xD800)) for _ in range(draw.randrange(60))),
        lambda: json.dumps({"type": draw.choice(["words", "start", "silence", "end", "interrupt", "listen", "x"])}),
        lambda: json.dumps({"type": "words", "text": "".join(draw.choices("abc .,!?\u0000é—", k=draw.randrange(80)))}),
        lambda: json.dumps({"type": "silence", "duration_s": draw.choice([1, -1, 1e9, "1", None, 0])}),
        lambda: "[" * 3000,
    )
    return draw.choice(kinds)()


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--hour", type=float, default=3600.0)
    parser.add_argument("--streams", type=int, default=16)
    parser.add_argument("--together", type=float, default=30.0)
    parser.add_argument("--part", nargs="+", choices=PARTS, default=PARTS)
    arguments = parser.parse_args()
    with service(live_ahead_s="1e9", live_s="1e6", workers="1") as (port, process):
        if "together" in arguments.part:
            asyncio.run(together(port, process, arguments.streams, arguments.together))
        if "slow" in arguments.part:
            asyncio.run(slow(port))
        if "garbage" in arguments.part:
            asyncio.run(garbage(port, process))
        if "memory" in arguments.part:
            asyncio.run(memory(port, process, arguments.hour))


if __name__ == "__main__":
    main()
