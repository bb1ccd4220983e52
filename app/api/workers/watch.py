"""Looks at the workers from outside: who is stopped, who has died, whose memory has grown too large."""

from collections.abc import Sequence
from dataclasses import dataclass

import psutil

from .families import family_of
from .processes import Worker


@dataclass(frozen=True, slots=True)
class Seen:
    """A worker as it was seen; `trouble` is why it cannot go on, None where it can."""

    worker: Worker
    trouble: str | None
    is_too_large: bool = False


def look(workers: Sequence[Worker], limit_bytes: int) -> tuple[Seen, ...]:
    """Each worker with all that it started. Memory counts beyond what was shared when the worker began."""
    return tuple(_seen(worker, limit_bytes) for worker in workers)


def is_stopped(pid: int) -> bool:
    """Whether a process is there, but was stopped."""
    try:
        return psutil.Process(pid).status() == psutil.STATUS_STOPPED
    except psutil.NoSuchProcess:
        return False


def _seen(worker: Worker, limit_bytes: int) -> Seen:
    pid = worker.process.pid
    try:
        family = family_of(worker.process)
        stopped = [each.pid for each in family if each.status() == psutil.STATUS_STOPPED]
        grown_bytes = sum(each.memory_info().rss for each in family) - worker.shared_bytes
    except psutil.NoSuchProcess:
        if worker.process.is_running():
            return Seen(worker, None)  # a process of its own ended as it was looked at
        return Seen(worker, f"worker {pid} has ended and is being replaced")
    if stopped:
        whose = "it" if pid in stopped else "its aligner"
        return Seen(worker, f"worker {pid} is being replaced: {whose} was stopped")
    if grown_bytes > limit_bytes:
        return Seen(worker, f"worker {pid} is being replaced: it took too much memory", is_too_large=True)
    return Seen(worker, None)
