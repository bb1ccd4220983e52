"""How much memory and processor time a worker may take, and what is told where the kernel refuses it more."""

import os
import resource
import signal
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Never

from ...errors import TooLargeError


def limit_memory(limit_bytes: int) -> None:
    """Lets this process, and each that it starts, write to so much memory beyond what it has now. Linux alone tells how
    much that is; elsewhere the service's watch is the only limit."""
    status = Path("/proc/self/status")
    if status.exists():
        [data] = [line for line in status.read_text().splitlines() if line.startswith("VmData:")]
        limit_bytes += int(data.split()[1]) * 1024
        resource.setrlimit(resource.RLIMIT_DATA, (limit_bytes, limit_bytes))


def too_large(limit_bytes: int) -> TooLargeError:
    """What is told of work that needs more memory than a worker may take."""
    return TooLargeError(
        "work_too_large", f"this takes more than the {limit_bytes} bytes of memory that a request may use; send less"
    )


_GIVES_WAY_AFTER = 0.1
_LOWEST = 19


class ProcessorTimeError(BaseException):
    """The time is up. Not an Exception, so that nothing on its way takes it for a mistake in what was sent."""


@contextmanager
def processor_time(limit_s: float) -> Iterator[None]:
    """A block that may take so many seconds of the processor, its own threads and the kernel's work for it included;
    after a tenth of them its process gives way to others. Only in a process's main thread. Raises
    ProcessorTimeError."""
    patience_s = limit_s * _GIVES_WAY_AFTER
    signal.signal(signal.SIGPROF, _late)
    signal.setitimer(signal.ITIMER_PROF, patience_s, limit_s - patience_s)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0)


def too_long(limit_s: float) -> TooLargeError:
    """What is told of a message that takes more of the processor."""
    return TooLargeError(
        "work_too_large", f"this takes more than the {limit_s:g} s of a processor that a message may use"
    )


def give_way() -> None:
    """This process works from now on when no other wants to. It cannot be taken back, but by root."""
    os.nice(_LOWEST - os.nice(0))


def _late(*_signal: object) -> None:
    """First this process gives way, the next time it is stopped."""
    signal.signal(signal.SIGPROF, _stop)
    give_way()


def _stop(*_signal: object) -> Never:
    raise ProcessorTimeError
