"""First come, first served, for those who were told to come again: their turn in the queue is kept while they are away.

A caller has one from its first refusal to its next answer that is none; it keeps its place among the others when it is
refused again. Whoever does not come back within `KEPT_S` of the time that it was told is forgotten.
"""

import math
import time
from collections.abc import Callable

MOST_KEPT = 1000
KEPT_S = 3.0


class Turns:
    """The callers that were told to come again, in the order in which they first came, and when they were to come."""

    def __init__(self, clock: Callable[[], float] = time.monotonic) -> None:
        self._clock = clock
        self._due_s: dict[str, float] = {}

    def keep(self, caller: str, again_after_s: float) -> None:
        """Of a caller that was told to come again; callers are told whole seconds."""
        self._forget()
        if caller in self._due_s or len(self._due_s) < MOST_KEPT:
            self._due_s[caller] = self._clock() + max(1, math.ceil(again_after_s))

    def take(self, caller: str) -> None:
        """The caller's turn has come."""
        self._due_s.pop(caller, None)

    def before(self, caller: str) -> int:
        """How many others' turns come first: of those that should be back by now and came before this caller did."""
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
