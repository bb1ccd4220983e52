"""Starts a service to be measured, monitors it from a separate process, and ends it.

`/healthz` is asked every 20 ms on a connection that is kept, with the time of each answer; memory is that of all the
service's processes, shared pages counted once (the sum of their proportional set sizes), every 50 ms.
"""

import json
import os
import re
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from http.client import HTTPConnection, HTTPException
from multiprocessing import get_context
from multiprocessing.connection import Connection
from pathlib import Path

import psutil

HOST = "127.0.0.1"
_LISTENS = re.compile(rb"listening on http://[^:]+:(\d+)")
_NURSERY = "understudy.api.workers.nursery"
PROBE_EVERY_S = 0.02
MEMORY_EVERY_S = 0.05
LONGEST_PROBE_S = 60.0


@dataclass(frozen=True, slots=True)
class Running:
    """A service's process, the port it listens on, and the session of all that its first nursery forks, which are
    nobody's children when that has been killed."""

    process: subprocess.Popen[bytes]
    port: int
    session: int

    def family(self) -> list[psutil.Process]:
        """All its processes, itself first."""
        return family(self.process.pid, self.session)

    def nursery(self) -> list[psutil.Process]:
        """The process that forks workers: of those that loaded everything, the one with children that did."""
        loaded = [each for each in self.family()[1:] if _NURSERY in _command(each)]
        return [each for each in loaded if any(_NURSERY in _command(child) for child in _children(each))]


@dataclass(frozen=True, slots=True)
class Watched:
    """How long `/healthz` took, each time, and the most memory seen."""

    health_s: tuple[float, ...]
    peak_mb: float

    @property
    def worst_s(self) -> float:
        return max(self.health_s, default=float("inf"))

    def percentile_s(self, percent: float) -> float:
        """The time that `percent` of the answers did not exceed."""
        return percentile(self.health_s, percent)


def percentile(values: tuple[float, ...], percent: float) -> float:
    """The value that `percent` of them do not exceed; nan without any."""
    ordered = sorted(values)
    return ordered[min(len(ordered) - 1, int(len(ordered) * percent / 100))] if ordered else float("nan")


@contextmanager
def serving(settings: Mapping[str, str] | None = None, *, log: Path | None = None) -> Iterator[Running]:
    """`understudy serve` on a free port, with `UNDERSTUDY_…` settings; ended, with all its processes, afterwards."""
    named = {f"UNDERSTUDY_{name.upper()}": value for name, value in (settings or {}).items()}
    path = log or Path(f"/tmp/understudy-serve-{os.getpid()}.log")
    command = [sys.executable, "-m", "understudy.cli", "serve", "--port", "0"]
    with path.open("wb") as out:
        process = subprocess.Popen(command, env=os.environ | named, stdout=out, stderr=out)
    running, forked = None, list[psutil.Process]()
    try:
        port = _port(process, path)
        [nursery] = psutil.Process(process.pid).children()
        running = Running(process, port, os.getsid(nursery.pid))
        yield running
    finally:
        if running and process.poll() is None:
            forked = running.family()[1:]
        process.send_signal(signal.SIGTERM)
        try:
            process.wait(30)
        except subprocess.TimeoutExpired:
            process.kill()
        for each in forked:
            if each.is_running():
                each.kill()


@contextmanager
def watching(service: Running) -> Iterator[Callable[[], Watched]]:
    """Watches until the function that is given is called."""
    ours, theirs = get_context("spawn").Pipe()
    watcher = get_context("spawn").Process(
        target=_watch, args=(theirs, service.process.pid, service.session, service.port), daemon=True
    )
    watcher.start()
    theirs.close()
    ours.recv()

    def seen() -> Watched:
        ours.send("enough")
        health_s, peak_mb = ours.recv()
        return Watched(tuple(health_s), peak_mb)

    try:
        yield seen
    finally:
        ours.close()
        watcher.join(LONGEST_PROBE_S + 5)
        if watcher.is_alive():
            watcher.kill()


def memory_mb(processes: Iterable[psutil.Process]) -> float:
    """The memory of processes, shared pages counted once."""
    total = 0
    for process in processes:
        try:
            total += process.memory_full_info().pss
        except (psutil.NoSuchProcess, psutil.AccessDenied):
            continue
    return total / 1e6


def family(pid: int, session: int) -> list[psutil.Process]:
    """A process, all below it, and all of a session."""
    try:
        found = [psutil.Process(pid), *psutil.Process(pid).children(recursive=True)]
    except psutil.NoSuchProcess:
        return []
    known = {each.pid for each in found}
    for other in psutil.pids():
        with suppress(psutil.NoSuchProcess, ProcessLookupError):
            if other not in known and os.getsid(other) == session:
                found.append(psutil.Process(other))
    return found


def _command(process: psutil.Process) -> str:
    with suppress(psutil.NoSuchProcess):
        return " ".join(process.cmdline())
    return ""


def _children(process: psutil.Process) -> list[psutil.Process]:
    with suppress(psutil.NoSuchProcess):
        return process.children()
    return []


def _port(process: subprocess.Popen[bytes], log: Path) -> int:
    while process.poll() is None:
        found = _LISTENS.search(log.read_bytes())
        if found:
            return int(found[1])
        time.sleep(0.05)
    raise RuntimeError(f"the service ended: {log.read_text()[-2000:]}")


def _watch(pipe: Connection, pid: int, session: int, port: int) -> None:
    """Asks and looks until told that it is enough."""
    health_s: list[float] = []
    peak_mb, looked_s = memory_mb(family(pid, session)), time.monotonic()
    pipe.send("ready")
    connection = HTTPConnection(HOST, port, timeout=LONGEST_PROBE_S)
    try:
        while not health_s or not pipe.poll(PROBE_EVERY_S):
            health_s.append(_asked(connection))
            if time.monotonic() - looked_s >= MEMORY_EVERY_S:
                peak_mb, looked_s = max(peak_mb, memory_mb(family(pid, session))), time.monotonic()
        pipe.send((health_s, peak_mb))
    except (EOFError, OSError):
        return


def _asked(connection: HTTPConnection) -> float:
    """Seconds until `/healthz` has answered; those of the longest wait where it has not. It is asked once more where
    the connection is closed, as it is by right when this process had no processor for `idle_s`."""
    began_s = time.perf_counter()
    for _ in range(2):
        try:
            connection.request("GET", "/healthz")
            answer = connection.getresponse()
            alive = answer.status == 200 and json.loads(answer.read())["status"] == "alive"
        except (OSError, HTTPException):
            connection.close()
        else:
            return time.perf_counter() - began_s if alive else LONGEST_PROBE_S
    return max(LONGEST_PROBE_S, time.perf_counter() - began_s)
