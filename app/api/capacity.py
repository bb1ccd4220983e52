"""How much the service does at a time, and for how long: so many lines in threads, each until its deadline."""

import asyncio
import time
from collections.abc import Awaitable, Callable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from typing import Self, TypeVar

from ..errors import ServiceError
from ..performance import Progress

Result = TypeVar("Result")


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

    def check(self, _stage: str = "") -> None:
        """Raises ServiceError `deadline_passed` when it has; as the progress of a performance it ends the work."""
        if self.remaining_s == 0:
            raise self.passed()

    def passed(self) -> ServiceError:
        return ServiceError("deadline_passed", f"not done within {self.limit_s:g} s; send a shorter line or try later")

    async def within(self, waiting: Awaitable[Result]) -> Result:
        """What `waiting` brings; raises ServiceError `deadline_passed`."""
        try:
            return await asyncio.wait_for(waiting, self.remaining_s)
        except TimeoutError:
            raise self.passed() from None


class Capacity:
    """Places for work in threads.

    A thread cannot be stopped from outside: work that passes its deadline is answered at once, ends at its next stage,
    and holds its place until then, so that there are never more threads than places.
    """

    def __init__(self, places: int) -> None:
        self._places = places
        self._busy = 0
        self._threads = ThreadPoolExecutor(places, thread_name_prefix="line")

    @property
    def busy(self) -> int:
        """How many lines are being performed."""
        return self._busy

    @property
    def is_full(self) -> bool:
        return self._busy >= self._places

    def require_place(self) -> None:
        """Raises ServiceError `service_full`."""
        if self.is_full:
            raise ServiceError("service_full", f"{self._places} lines are being performed; try again in a second")

    async def run(self, work: Callable[[Progress], Result], deadline: Deadline) -> Result:
        """What `work` returns or raises; raises ServiceError `service_full` or `deadline_passed`."""
        self.require_place()
        self._busy += 1
        running = asyncio.get_running_loop().run_in_executor(self._threads, work, deadline.check)
        running.add_done_callback(self._leave)
        await asyncio.wait({running}, timeout=deadline.remaining_s)
        if not running.done():
            raise deadline.passed()
        return running.result()

    def close(self) -> None:
        """Waits for the work that is under way."""
        self._threads.shutdown(cancel_futures=True)

    def _leave(self, running: "asyncio.Future[Result]") -> None:
        self._busy -= 1
        if not running.cancelled():
            running.exception()  # an error that nobody waits for any more is no news
