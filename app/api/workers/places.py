"""The places of jobs that wait for a worker, which clients share.

A client that asks alone may take all of them. While others ask, it may take half of them as it comes, and of the other
half no more than its share; a caller who returns when told has places beyond the last, so that newcomers, however many
and however often they ask, do not keep it out. Jobs are served in rounds, one of each client in a round (start-time
fair queuing: Goyal, Vin and Cheng, 1996).
"""

import asyncio
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Generic, TypeVar

from .turns import MOST_CLIENTS, Caller, Turns

Given = TypeVar("Given")

ASKS_S = 5.0
"""A client that has not asked for so long has no share."""


@dataclass(frozen=True, slots=True, eq=False)
class Place(Generic[Given]):
    """Where a client's job waits until it is given what it waits for."""

    client: str
    round: int
    given: "asyncio.Future[Given]"


class Places(Generic[Given]):
    """`length` places, and half as many for those who return when told. Belongs to an event loop."""

    def __init__(self, length: int, turns: Turns | None = None, clock: Callable[[], float] = time.monotonic) -> None:
        self._length = length
        self.turns = turns or Turns()
        self._clock = clock
        self._waiting: list[Place[Given]] = []
        self._asked_s: dict[str, float] = {}
        self._round = 0
        self._last: dict[str, int] = {}  # rounds of the clients' last jobs, where they are to come

    def __len__(self) -> int:
        """How many jobs wait."""
        return len(self._waiting)

    def has_room(self, caller: Caller, more: int = 0) -> bool:
        """Whether the caller's job may wait. `more` jobs wait without taking a place."""
        self._note(caller.client)
        free, kept = self._length + more - len(self._waiting), (self._length + 1) // 2
        share = max(1, (self._length + kept) // len(self._asked_s))
        if free <= self._length // 2 and len(self._asked_s) > 1 and self._of(caller.client) >= share:
            return False
        before = self.turns.before(caller)
        return free > 0 if before is None else free + kept > before

    @contextmanager
    def place(self, client: str) -> Iterator["asyncio.Future[Given]"]:
        """A place until the block ends."""
        given: asyncio.Future[Given] = asyncio.get_running_loop().create_future()
        self._last[client] = max(self._round, self._last.get(client, 0)) + 1
        place = Place(client, self._last[client], given)
        self._waiting.append(place)
        try:
            yield place.given
        finally:
            if place in self._waiting:
                self._waiting.remove(place)

    def next(self) -> "asyncio.Future[Given] | None":
        """What the next job waits for, which leaves its place; None if nobody waits."""
        waiting = [place for place in self._waiting if not place.given.done()]
        if not waiting:
            return None
        place = min(waiting, key=lambda each: each.round)
        self._waiting.remove(place)
        self._round = place.round - 1
        self._last = {client: last for client, last in self._last.items() if last > self._round}
        return place.given

    def _of(self, client: str) -> int:
        return sum(place.client == client for place in self._waiting)

    def _note(self, client: str) -> None:
        """Records that a client asks, and forgets those who do no more."""
        now_s = self._clock()
        self._asked_s.pop(client, None)
        for other, asked_s in list(self._asked_s.items()):
            if asked_s >= now_s - ASKS_S and len(self._asked_s) < MOST_CLIENTS:
                break  # the others asked later
            del self._asked_s[other]
        self._asked_s[client] = now_s
