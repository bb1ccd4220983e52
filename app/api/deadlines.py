"""When a request must be answered."""

import asyncio
import time
from collections.abc import Awaitable
from dataclasses import dataclass
from typing import Self, TypeVar

from ..errors import ServiceError

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

    def passed(self) -> ServiceError:
        return ServiceError("deadline_passed", f"not done within {self.limit_s:g} s; send a shorter line or try later")

    async def within(self, waiting: Awaitable[Result]) -> Result:
        """What `waiting` brings; raises ServiceError `deadline_passed`."""
        try:
            async with asyncio.timeout(self.remaining_s):
                return await waiting
        except TimeoutError:
            raise self.passed() from None
