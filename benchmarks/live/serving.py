"""A service of its own for benchmarks of live streams, streams to it, and a line said over and over."""

import json
import os
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

from understudy.files import resource_folder

CHUNK_S = 0.04
RATE_HZ = 16_000
CHUNK_BYTES = 2 * round(CHUNK_S * RATE_HZ)
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


def processor_s(process: psutil.Process) -> float:
    """What a process has used; its last figure is lost when it ends."""
    with suppress(psutil.NoSuchProcess):
        times = process.cpu_times()
        return float(times.user + times.system)
    return float("nan")
