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
from enum import IntEnum
from pathlib import Path
from typing import Self, TypeVar

from ...errors import ServiceError, TooLargeError
from ...settings import processor_count

Result = TypeVar("Result")

_MOST_S, _BRIEF_S, _SLICE_S = 0.1, 0.07, 0.05
"""Seconds that a stream may have saved up, the part of them that is brief work, and a slice of long work
(`ProcessorShare`)."""

_EARNED_BY_SOUND, _EARNED_BY_WAITING = 0.5, 0.05
"""The processor time that a stream earns in a second of sound, and in any second; with frames it uses .15 a second."""

_HANDING_ON_S, _SHORTEST_S = 0.005, 0.001

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


class Turn(IntEnum):
    """What a process waits its turn for: the places in the file by which several take turns."""

    BRIEF = 0
    LONG = 1


class ProcessorShare:
    """How a stream shares the processors with other streams and with lines: it takes what it has saved up as it comes,
    and more in turns.

    A stream saves up to .1 s, from the time that its sound lasts unless that is ahead of the clock. When less than .07
    s are left, its work is brief work, of which one stream's is done at a time; when nothing is left, it is long work,
    of which one stream's is done at a time, in slices with as long a rest between, so that all of them together take
    half a core. (Priorities alone do not do it: a scheduler that groups processes by session, as Linux's does by
    default, compares them within a session only.) There is such a turn for every two cores.
    """

    def __init__(self, turns: int) -> None:
        """`turns` is the descriptor of a file, open for writing, that all streams share. `turn` is what it has."""
        self._turns = turns
        self._place = len(Turn) * (os.getpid() % max(1, processor_count() // 2))
        self._left_s, self._spent_s, self._taken_at_s, self._owed_s = _MOST_S, 0.0, 0.0, 0.0
        self._credited_s = self._passed_s = 0.0
        self.turn: Turn | None = None

    def earn(self, heard_s: float, passed_s: float) -> None:
        """Saves what a stream earned since the last time: it has lasted `passed_s`, and its sound `heard_s`."""
        credited_s = min(heard_s, passed_s)
        earned_s = _EARNED_BY_WAITING * (passed_s - self._passed_s)
        if heard_s <= passed_s:
            earned_s += _EARNED_BY_SOUND * (credited_s - self._credited_s)
        self._left_s = min(_MOST_S, self._left_s + earned_s)
        self._credited_s, self._passed_s = credited_s, passed_s

    def begin(self) -> float:
        """Waits for a turn, if the work that now begins needs one. The processor time until `go_on` is to be called."""
        self._spent_s = self._taken_at_s = 0.0
        return self._left_s - _BRIEF_S if self._left_s > _BRIEF_S else self._take_turn()

    def go_on(self, spent_s: float) -> float:
        """Lets others have their turns and waits for the next, after so much processor time since the work began. The
        processor time until this is to be called again."""
        self._spent_s = spent_s
        if self.turn is Turn.LONG:
            self._give_up_turn()
            time.sleep(_HANDING_ON_S)  # who waits is woken meanwhile
        return self._take_turn()

    def end(self, spent_s: float) -> None:
        """Gives up the turn; what it has not rested for is rested for in the next one."""
        self._spent_s = spent_s
        self._give_up_turn()
        self._left_s = max(0.0, self._left_s - spent_s)

    def _take_turn(self) -> float:
        left_s = self._left_s - self._spent_s
        turn = Turn.BRIEF if left_s > 0 else Turn.LONG
        if self.turn is not turn:
            self._give_up_turn()
            fcntl.lockf(self._turns, fcntl.LOCK_EX, 1, self._place + turn)
            self.turn, self._taken_at_s = turn, self._spent_s
        if turn is Turn.LONG:
            time.sleep(self._owed_s)
            self._owed_s = 0.0
        return left_s if left_s > 0 else _SLICE_S

    def _give_up_turn(self) -> None:
        if self.turn is not None:
            fcntl.lockf(self._turns, fcntl.LOCK_UN, 1, self._place + self.turn)
            self.turn, self._owed_s = None, self._spent_s - self._taken_at_s


@contextmanager
def processor_time(limit_s: float, pace: ProcessorShare) -> Iterator[None]:
    """Limits the processor time of a block, user and system time of all threads, seconds, which it takes at that pace;
    after a tenth of the limit it has the lowest priority. Only in the main thread. Raises ProcessorTimeError."""
    began_s = time.process_time()

    def tick(*_signal: object) -> None:
        spent_s = time.process_time() - began_s
        if spent_s >= limit_s:
            raise ProcessorTimeError
        if spent_s >= limit_s * _GIVES_WAY_AFTER:
            give_way()
        wait(pace.go_on(spent_s))

    def wait(for_s: float) -> None:
        signal.setitimer(signal.ITIMER_PROF, max(_SHORTEST_S, min(for_s, limit_s * _GIVES_WAY_AFTER)))

    signal.signal(signal.SIGPROF, tick)
    wait(pace.begin())
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0)
        pace.end(time.process_time() - began_s)


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
