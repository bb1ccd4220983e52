"""A time index over the behaviours kept so far: finding neighbours costs the same in a line of any length.

Behaviours lie in cells of `CELL_S` seconds, each in all that it overlaps. Nothing is changed in place: adding to what
is kept makes another, so that several attempts can start from the same. Times are seconds.
"""

from collections.abc import Iterable, Iterator
from math import floor
from typing import Self

from ...model import Behavior, Channel
from .anchoring import PlacedBehavior

CELL_S = 2.0


class TimeIndex:
    """The behaviours kept so far, in the order in which they were."""

    __slots__ = ("_by_place", "_cells", "_next", "gestures")

    def __init__(self, placed: Iterable[PlacedBehavior] = ()) -> None:
        self._by_place: dict[int, PlacedBehavior] = {}
        self._cells: dict[int, tuple[int, ...]] = {}
        self._next = 0
        self.gestures = 0
        """How many of them are gestures."""
        for each in placed:
            self._add(each)

    def __iter__(self) -> Iterator[PlacedBehavior]:
        return iter(self._by_place.values())

    def near(self, from_s: float, to_s: float) -> tuple[PlacedBehavior, ...]:
        """Those that are under way between two times, in their order."""
        return tuple(
            each
            for each in map(self._by_place.__getitem__, self._places(from_s, to_s))
            if each.behavior.sync.end > from_s and each.behavior.sync.start < to_s
        )

    def gestures_near(self, from_s: float, to_s: float) -> Iterator[Behavior]:
        """The gestures among those."""
        return (each.behavior for each in self.near(from_s, to_s) if each.behavior.kind is Channel.GESTURE)

    def with_one_more(
        self, added: PlacedBehavior, changed: Iterable[tuple[PlacedBehavior, PlacedBehavior]] = ()
    ) -> Self:
        """These and one more; `changed` are some of them, each with what it becomes."""
        other = self._copy()
        for before, after in changed:
            begun_s = before.behavior.sync.start
            place = next(each for each in self._places(begun_s, begun_s) if self._by_place[each] is before)
            other._change(place, after)
        other._add(added)
        return other

    def without(self, one: PlacedBehavior) -> Self:
        """These but one."""
        return type(self)(each for each in self if each is not one)

    def _places(self, from_s: float, to_s: float) -> list[int]:
        return sorted({place for cell in _cells(from_s, to_s) for place in self._cells.get(cell, ())})

    def _copy(self) -> Self:
        other = type(self)()
        other._by_place, other._cells = self._by_place.copy(), self._cells.copy()
        other._next, other.gestures = self._next, self.gestures
        return other

    def _add(self, one: PlacedBehavior) -> None:
        self._change(self._next, one)
        self._next += 1
        self.gestures += one.behavior.kind is Channel.GESTURE

    def _change(self, place: int, one: PlacedBehavior) -> None:
        """What becomes shorter stays in its cells; `near` looks at its times."""
        self._by_place[place] = one
        for cell in _cells(one.behavior.sync.start, one.behavior.sync.end):
            if place not in self._cells.get(cell, ()):
                self._cells[cell] = (*self._cells.get(cell, ()), place)


def _cells(from_s: float, to_s: float) -> range:
    return range(floor(from_s / CELL_S), floor(to_s / CELL_S) + 1)
