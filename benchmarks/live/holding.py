"""Robustness of live streams: long, many, slow, interrupted and invalid ones, with a service of its own.

    python -m benchmarks.live.holding [--hour SECONDS] [--streams N] [--together SECONDS] [--part NAME …]

- memory: one stream of SECONDS of sound (3600), with frames, sent as fast as it is taken, with words, interruptions and
  silences on the way: memory of its process, a minute in and at the end.
- together: N streams (16) with sound at its own pace for SECONDS (30): messages late, processor time, `/healthz`.
- slow: a client that reads nothing, and one that reads a tenth of the time.
- garbage: random text and bytes as messages, streams broken off anywhere; then a stream as ever.
"""

import argparse
import asyncio
import json
import os
import random
import socket
import subprocess
import sys
import time
from collections.abc import AsyncIterator, Iterator
from contextlib import asynccontextmanager, contextmanager, suppress

import numpy as np
import psutil
import requests
import soundfile
from websockets.asyncio.client import ClientConnection, connect
from websockets.exceptions import ConnectionClosed

from understudy.resources import resource_folder

CHUNK_S = 0.04
RATE_HZ = 16_000
CHUNK_BYTES = 2 * round(CHUNK_S * RATE_HZ)
WARM_S = 60.0
"""What is loaded when first needed, and what caches hold, is there by then."""

MOST_SENT_AHEAD_S = 2.0
"""How much sound may wait in buffers, so that memory is measured when so much has been heard, not sent."""

PARTS = ("memory", "together", "slow", "garbage")
START = {"type": "start", "sample_rate_hz": RATE_HZ}


def speech() -> bytes:
    """The bundled line and two seconds of silence, as samples."""
    samples, rate_hz = soundfile.read(resource_folder("examples") / "example.flac", dtype="int16")
    assert rate_hz == RATE_HZ
    return bytes(np.concatenate([samples, np.zeros(2 * RATE_HZ, dtype=np.int16)]).astype("<i2").tobytes())


PCM = speech()


def chunk(number: int) -> bytes:
    """The chunk of that number of the line said over and over."""
    begin = number * CHUNK_BYTES % (len(PCM) - CHUNK_BYTES)
    return PCM[begin : begin + CHUNK_BYTES]


@contextmanager
def service(**settings: str) -> Iterator[tuple[int, psutil.Process]]:
    """A service, its port and its process."""
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    names = {f"UNDERSTUDY_{name.upper()}": value for name, value in settings.items()}
    command = [sys.executable, "-m", "understudy.cli", "--quiet", "serve", "--port", str(port)]
    process = subprocess.Popen(command, env=os.environ | names)
    try:
        while True:
            with suppress(requests.ConnectionError):
                if requests.get(f"http://127.0.0.1:{port}/readyz", timeout=5).ok:
                    break
            time.sleep(0.2)
        yield port, psutil.Process(process.pid)
    finally:
        process.terminate()
        process.wait(20)


@asynccontextmanager
async def stream(port: int, **start: object) -> AsyncIterator[ClientConnection]:
    address = f"ws://127.0.0.1:{port}/live"
    async with connect(address, max_size=None, compression=None, ping_interval=None) as connection:
        await connection.send(json.dumps(START | start))
        assert json.loads(await connection.recv())["type"] == "ready"
        yield connection


def newest(of: psutil.Process) -> psutil.Process:
    """The process that was started last."""
    return max(of.children(recursive=True), key=lambda each: (each.create_time(), each.pid))


async def memory(port: int, process: psutil.Process, sound_s: float) -> None:
    async with stream(port, frames=30) as connection:
        worker, seen, began_s = newest(process), list[tuple[float, float, float]](), time.monotonic()

        heard_s = 0.0

        async def read() -> int:
            nonlocal heard_s
            count = 0
            with suppress(ConnectionClosed):
                async for text in connection:
                    told, count = json.loads(text), count + 1
                    heard_s = told.get("time_s", heard_s)
            return count

        reading = asyncio.create_task(read())
        total = round(sound_s / CHUNK_S)
        for number in range(total):
            await connection.send(chunk(number))
            at_s = number * CHUNK_S
            while heard_s < at_s - MOST_SENT_AHEAD_S and not reading.done():
                await asyncio.sleep(0.01)
            if number % 250 == 0:
                await connection.send(json.dumps({"type": "words", "text": "No, I have never seen those."}))
            if number % 700 == 699:
                await connection.send(json.dumps({"type": "interrupt"}))
            if number % (total // 60) == 0:
                used = worker.memory_full_info()
                seen.append((at_s, used.uss / 2**20, used.rss / 2**20))
        await connection.send(json.dumps({"type": "end"}))
        count = await reading
    wall_s = time.monotonic() - began_s
    print(f"memory: {sound_s:.0f} s of sound in {wall_s:.0f} s, {count} messages; MB from a minute on:")
    settled = np.array([row for row in seen if row[0] >= WARM_S])
    for name, megabytes in (("own pages", settled[:, 1]), ("with shared ones", settled[:, 2])):
        quarters = [float(part.mean()) for part in np.array_split(megabytes, 4)]
        growth = 100 * (megabytes[-3:].mean() / megabytes[:3].mean() - 1)
        print(f"  {name}: {', '.join(f'{each:.1f}' for each in quarters)} by quarters, {growth:+.1f} % in all")


async def together(port: int, process: psutil.Process, streams: int, lasting_s: float) -> None:
    late_s: list[float] = []
    health_s: list[float] = []

    async def one(number: int) -> None:
        async with stream(port, frames=60 if number % 2 else None, seed=number) as connection:
            began_s = time.monotonic()

            async def read() -> None:
                with suppress(ConnectionClosed):
                    async for text in connection:
                        told = json.loads(text)
                        heard_s = told.get("heard_s", told.get("time_s"))
                        if heard_s is not None:
                            late_s.append(time.monotonic() - began_s - heard_s)

            reading = asyncio.create_task(read())
            for place in range(round(lasting_s / CHUNK_S)):
                await asyncio.sleep(max(0.0, began_s + (place + 1) * CHUNK_S - time.monotonic()))
                await connection.send(chunk(place + 31 * number))
            await connection.send(json.dumps({"type": "end"}))
            await reading

    async def probe() -> None:
        while True:
            began_s = time.monotonic()
            await asyncio.to_thread(requests.get, f"http://127.0.0.1:{port}/healthz", timeout=10)
            health_s.append(time.monotonic() - began_s)
            await asyncio.sleep(0.2)

    probing = asyncio.create_task(probe())
    before, began_s, waiting = (
        processor_s(process),
        time.monotonic(),
        [asyncio.create_task(one(k)) for k in range(streams)],
    )
    await asyncio.sleep(lasting_s - 1)
    spent = (processor_s(process) - before) / (time.monotonic() - began_s)
    await asyncio.gather(*waiting)
    probing.cancel()
    print(f"together: {streams} streams (every second with frames at 60), {lasting_s:.0f} s: messages late by")
    print(f"  {percentiles(late_s)}; processors busy {spent:.2f}; /healthz {percentiles(health_s)}")


def processor_s(process: psutil.Process) -> float:
    """What a process and its children have used."""
    total = 0.0
    for each in [process, *process.children(recursive=True)]:
        with suppress(psutil.NoSuchProcess):
            times = each.cpu_times()
            total += times.user + times.system
    return total


def percentiles(values: list[float]) -> str:
    median, most, longest = np.percentile(values, [50, 95, 100])
    return f"median {1000 * median:.0f} ms, p95 {1000 * most:.0f}, longest {1000 * longest:.0f}"


async def slow(port: int) -> None:
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
    async with stream(port, frames=60) as connection:
        frames = events = 0
        for number in range(500):
            await connection.send(chunk(number))
            if number % 10 == 0:
                with suppress(TimeoutError):
                    for _ in range(5):
                        told = json.loads(await asyncio.wait_for(connection.recv(), 0.05))
                        frames, events = frames + (told["type"] == "frame"), events + (told["type"] != "frame")
        await connection.send(json.dumps({"type": "end"}))
        with suppress(ConnectionClosed):
            async for text in connection:
                told = json.loads(text)
                frames, events = frames + (told["type"] == "frame"), events + (told["type"] != "frame")
    print(f"slow: a client that reads now and then got {frames} of 1200 frames and {events} other messages,")
    print(f"  the last {told['type']}")


async def garbage(port: int, process: psutil.Process) -> None:
    draw = random.Random(0)
    codes: dict[str, int] = {}
    for _ in range(150):
        with suppress(ConnectionClosed, TimeoutError):
            async with connect(f"ws://127.0.0.1:{port}/live", compression=None) as connection:
                if draw.random() < 0.6:
                    await connection.send(json.dumps(START | {"frames": draw.choice([None, 30])}))
                for _ in range(draw.randrange(4)):
                    await connection.send(_garbage(draw))
                if draw.random() < 0.3:
                    connection.transport.abort()
                while True:
                    told = json.loads(await asyncio.wait_for(connection.recv(), 0.3))
                    if told["type"] == "error":
                        codes[told["code"]] = codes.get(told["code"], 0) + 1
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
