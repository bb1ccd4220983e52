"""When refused callers should retry, and who is served first when they do: their place in the queue is kept meanwhile.

A caller has a turn from its first refusal until it is accepted, and keeps its place if it is refused again. A caller
that does not return within `KEPT_S` of the time it was given loses it.
"""

import math
import time
from collections.abc import Callable

MOST_KEPT = 1000
KEPT_S = 3.0

_WEIGHT = 0.1
"""Of the newest job in the mean, which is thus that of the last ten or so."""

_FIRST_GUESS_S = 0.5


class Turns:
    """The refused callers in the order of their first requests, with the times at which they should retry."""

    def __init__(self, clock: Callable[[], float] = time.monotonic) -> None:
        self._clock = clock
        self._due_s: dict[str, float] = {}

    def keep(self, caller: str, again_after_s: float) -> None:
        """Records a refused caller; Retry-After has whole seconds."""
        self._forget()
        if caller in self._due_s or len(self._due_s) < MOST_KEPT:
            self._due_s[caller] = self._clock() + max(1, math.ceil(again_after_s))

    def take(self, caller: str) -> None:
        """Ends the caller's turn: it is accepted."""
        self._due_s.pop(caller, None)

    def before(self, caller: str) -> int:
        """How many others come first: callers due by now whose first request was earlier."""
        self._forget()
        count, now_s = 0, self._clock()
        for other, due_s in self._due_s.items():
            if other == caller:
                break
            count += due_s <= now_s
        return count

    def _forget(self) -> None:
        until_s = self._clock() - KEPT_S
        for caller in [each for each, due_s in self._due_s.items() if due_s < until_s]:
            del self._due_s[caller]


class ServiceTimes:
    """A moving average of job durations in seconds, for Retry-After."""

    def __init__(self) -> None:
        self._mean_s: float | None = None

    @property
    def mean_s(self) -> float:
        return _FIRST_GUESS_S if self._mean_s is None else self._mean_s

    def add(self, took_s: float) -> None:
        self._mean_s = took_s if self._mean_s is None else self._mean_s + _WEIGHT * (took_s - self._mean_s)
