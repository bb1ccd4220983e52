"""The limits of a worker's memory and processor time and of a request's duration, with their errors."""

import asyncio
import fcntl
import os
import resource
import signal
import time
from collections.abc import Awaitable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Self, TypeVar

from ...errors import ServiceError, TooLargeError

Result = TypeVar("Result")

_FREE_S, _SLICE_S = 0.1, 0.05
"""A message works without rest for so long, seconds of the processor; then in slices, as long a rest after each."""

_HANDING_ON_S = 0.005

_GIVES_WAY_AFTER = 0.1
_LOWEST = 19


def limit_memory(limit_bytes: int) -> None:
    """Limits the memory that this process and its children may allocate beyond what they have now. Linux only;
    elsewhere the service's watch is the only limit."""
    status = Path("/proc/self/status")
    if status.exists():
        [data] = [line for line in status.read_text().splitlines() if line.startswith("VmData:")]
        limit_bytes += int(data.split()[1]) * 1024
        resource.setrlimit(resource.RLIMIT_DATA, (limit_bytes, limit_bytes))


def too_large(limit_bytes: int) -> TooLargeError:
    """The error of a job that needs more memory than a worker may use."""
    return TooLargeError(
        "work_too_large", f"this takes more than the {limit_bytes} bytes of memory that a request may use; send less"
    )


class ProcessorTimeError(BaseException):
    """The time is up. Not an Exception, so that no handler on its way takes it for an error in the input."""


@contextmanager
def processor_time(limit_s: float, *, turns: int | None = None) -> Iterator[None]:
    """Limits the processor time of a block, user and system time of all threads, seconds. What takes long makes room
    for others: it rests in between, and after a tenth of the limit has the lowest priority. `turns` is the descriptor
    of a file, open for writing, that several processes share: of those that take long one works at a time, so that
    all of them together take half a core (priorities alone do not do it: a scheduler that groups processes by session,
    as Linux's does by default, compares them within a session only). Only in the main thread. Raises
    ProcessorTimeError."""
    began_s = time.process_time()

    def tick(*_signal: object) -> None:
        spent_s = time.process_time() - began_s
        if spent_s >= limit_s:
            raise ProcessorTimeError
        if spent_s >= limit_s * _GIVES_WAY_AFTER:
            give_way()
        time.sleep(_SLICE_S)
        if turns is not None:
            _let_others_work(turns)

    signal.signal(signal.SIGPROF, tick)
    signal.setitimer(signal.ITIMER_PROF, min(_FREE_S, limit_s * _GIVES_WAY_AFTER), _SLICE_S)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0)
        if turns is not None:
            fcntl.lockf(turns, fcntl.LOCK_UN)


def _let_others_work(turns: int) -> None:
    """Gives up the turn, if this process has it, and waits for the next. Who waits is woken while this one sleeps."""
    fcntl.lockf(turns, fcntl.LOCK_UN)
    time.sleep(_HANDING_ON_S)
    fcntl.lockf(turns, fcntl.LOCK_EX)


def too_long(limit_s: float) -> TooLargeError:
    """The error of a message that takes too much processor time."""
    return TooLargeError(
        "work_too_large", f"this takes more than the {limit_s:g} s of processor time that a message may use"
    )


def give_way() -> None:
    """Lowers this process's priority to the lowest; only root could raise it again."""
    os.nice(_LOWEST - os.nice(0))


@dataclass(frozen=True, slots=True)
class Deadline:
    """When a request must be answered; `ends_s` is a time of the monotonic clock."""

    limit_s: float
    ends_s: float

    @classmethod
    def starting_now(cls, limit_s: float) -> Self:
        return cls(limit_s, time.monotonic() + limit_s)

    @property
    def remaining_s(self) -> float:
        return max(0.0, self.ends_s - time.monotonic())

    def passed(self) -> ServiceError:
        return ServiceError("deadline_passed", f"not done within {self.limit_s:g} s; send a shorter line or try later")

    async def within(self, waiting: Awaitable[Result]) -> Result:
        """What `waiting` brings; raises ServiceError `deadline_passed`."""
        try:
            async with asyncio.timeout(self.remaining_s):
                return await waiting
        except TimeoutError:
            raise self.passed() from None
