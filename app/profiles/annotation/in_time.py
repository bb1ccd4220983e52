"""Things found by a stretch of time without a look at each of them, so that an hour of annotation is read in seconds.

Times are seconds, or any other numbers in which things lie one after the other, such as those of words.
"""

from bisect import bisect_left, bisect_right
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from itertools import accumulate
from typing import Generic, TypeVar

Thing = TypeVar("Thing")


@dataclass(frozen=True, slots=True, eq=False)
class InTime(Generic[Thing]):
    """Things in order of their starts; they may overlap. `latest_ends` has for each the latest end up to it."""

    things: tuple[Thing, ...]
    starts: tuple[float, ...]
    ends: tuple[float, ...]
    latest_ends: tuple[float, ...]

    @classmethod
    def of(cls, things: Iterable[Thing], times: Callable[[Thing], tuple[float, float]]) -> "InTime[Thing]":
        """The things; `times` has the start and end of one."""
        timed = sorted(((*times(thing), thing) for thing in things), key=lambda each: each[:2])
        ends = tuple(end for _start, end, _thing in timed)
        starts = tuple(start for start, _end, _thing in timed)
        return cls(tuple(thing for _start, _end, thing in timed), starts, ends, tuple(accumulate(ends, max)))

    def touching(self, start: float, end: float) -> tuple[Thing, ...]:
        """Those that share time with the stretch."""
        first, after = bisect_right(self.latest_ends, start), bisect_left(self.starts, end)
        return tuple(self.things[place] for place in range(first, after) if self.ends[place] > start)

    def within(self, start: float, end: float) -> tuple[Thing, ...]:
        """Those that lie in the stretch."""
        first, after = bisect_left(self.starts, start), bisect_right(self.starts, end)
        return tuple(self.things[place] for place in range(first, after) if self.ends[place] <= end)

    def any_holds(self, start: float, end: float) -> bool:
        """Whether the stretch lies in one of them."""
        begun = bisect_right(self.starts, start)
        return begun > 0 and self.latest_ends[begun - 1] >= end
