"""A process with all that it started, found without a look at every other process of the machine.

Linux tells the children of each thread of a process (`/proc/PID/task/TID/children`); where it does not, psutil looks
through all processes, which on a busy machine takes so long that the event loop feels it.
"""

from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path

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
    """What all threads of a process have started; nothing when it has ended."""
    found: list[int] = []
    with suppress(OSError):
        for thread in (_PROCESSES / str(pid) / "task").iterdir():
            found += map(int, (thread / "children").read_text().split())
    return found
