"""A process with all that it started: found without a look at every other process of the machine, and ended with the
service, however that ends.

Linux lists the children of each thread (`/proc/PID/task/TID/children`). Elsewhere psutil scans all processes, which on
a busy machine delays the event loop.
"""

import os
import select
import socket
import threading
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path
from typing import Never

import psutil

_PROCESSES = Path("/proc")


def family_of(process: psutil.Process) -> list[psutil.Process]:
    """The process, and all below it. Raises psutil.NoSuchProcess when it has ended."""
    if not process.is_running():
        raise psutil.NoSuchProcess(process.pid)
    if not (_PROCESSES / "thread-self" / "children").exists():
        return [process, *process.children(recursive=True)]
    return [process, *_below(process.pid)]


def _below(pid: int) -> Iterator[psutil.Process]:
    for child in _children(pid):
        with suppress(psutil.NoSuchProcess):
            yield psutil.Process(child)
        yield from _below(child)


def _children(pid: int) -> list[int]:
    """The children of all threads of a process; none when it has ended."""
    found: list[int] = []
    with suppress(OSError):
        for thread in (_PROCESSES / str(pid) / "task").iterdir():
            found += map(int, (thread / "children").read_text().split())
    return found


def end_with(service: socket.socket) -> None:
    """Ends this process when the other end of its socket closes."""
    threading.Thread(target=_wait, args=(service,), daemon=True).start()


def end() -> Never:
    """Ends this process and its children."""
    for child in psutil.Process().children(recursive=True):
        child.kill()
    os._exit(0)


def _wait(service: socket.socket) -> None:
    poller = select.poll()
    poller.register(service, 0)
    poller.poll()  # returns when the other end has gone
    end()
