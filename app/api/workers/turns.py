"""When refused callers should retry, and who is served first when they do: their place in the queue is kept meanwhile.
Those who do not wait are made to.

A caller has a turn from its first refusal until it is accepted, and keeps its place if it is refused again. A caller
that does not return within `KEPT_S` of the time it was given loses it. Turns belong to clients: whoever gives each
request another name gets many turns, but its second comes after the first of all others.
"""

import asyncio
import math
import time
from collections import deque
from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager
from dataclasses import dataclass
from itertools import count

from ...errors import ServiceError

MOST_CLIENTS, MOST_EACH = 1000, 32
"""Turns are kept of so many clients, and for so many requests of each."""

KEPT_S = 3.0

_WEIGHT = 0.1
"""Of the newest job in the mean, which is thus that of the last ten or so."""

_FIRST_GUESS_S = 0.5


@dataclass(frozen=True, slots=True)
class Caller:
    """Who asks: a client, by what it cannot choose anew each time (its key, else its address), and what it calls its
    request."""

    client: str = ""
    request: str = ""


@dataclass(frozen=True, slots=True)
class _Turn:
    """`first` is the number of the refusal that began it."""

    first: int
    due_s: float


class Turns:
    """The refused callers in the order of their first requests, with the times at which they should retry."""

    def __init__(self, clock: Callable[[], float] = time.monotonic) -> None:
        self._clock = clock
        self._kept: dict[str, dict[str, _Turn]] = {}
        self._numbers = count()

    def keep(self, caller: Caller, again_after_s: float) -> None:
        """Records a refused caller; Retry-After has whole seconds."""
        self._forget()
        if caller.client not in self._kept and len(self._kept) >= MOST_CLIENTS:
            return
        turns = self._kept.setdefault(caller.client, {})
        earlier = turns.get(caller.request)
        if earlier or len(turns) < MOST_EACH:
            due_s = self._clock() + max(1, math.ceil(again_after_s))
            turns[caller.request] = _Turn(earlier.first if earlier else next(self._numbers), due_s)

    def take(self, caller: Caller) -> None:
        """Ends the caller's turn: it is accepted."""
        turns = self._kept.get(caller.client, {})
        turns.pop(caller.request, None)
        if not turns:
            self._kept.pop(caller.client, None)

    def before(self, caller: Caller) -> int | None:
        """How many others come first, of those who are due; None if the caller is not, and comes after all of them.
        The first turns of all clients come before their second ones, and so on, in the order of the first requests."""
        self._forget()
        mine = self._kept.get(caller.client, {}).get(caller.request)
        if mine is None or mine.due_s > self._clock():
            return None
        ranks = {client: self._due(client) for client in self._kept}
        rank = ranks.pop(caller.client).index(mine.first)
        earlier = sum(each < mine.first for due in ranks.values() for each in due[rank : rank + 1])
        return rank + sum(min(len(due), rank) for due in ranks.values()) + earlier

    def _due(self, client: str) -> list[int]:
        """The client's turns that are due, in the order of their first requests."""
        now_s = self._clock()
        return sorted(turn.first for turn in self._kept[client].values() if turn.due_s <= now_s)

    def _forget(self) -> None:
        until_s = self._clock() - KEPT_S
        for client, turns in list(self._kept.items()):
            self._kept[client] = kept = {name: turn for name, turn in turns.items() if turn.due_s >= until_s}
            if not kept:
                del self._kept[client]


MOST_PROMPT, WITHIN_S, HELD_S, MOST_HELD = 4, 1.0, 0.5, 64
"""A client is refused at once so often within a second, and after half a second from then on; so many at a time."""


class Refusals:
    """Holds refusals back from clients that ask again at once, however often they are refused: answering them would
    take the event loop from all others. Who comes again when told is refused at once. Belongs to an event loop."""

    def __init__(self, clock: Callable[[], float] = time.monotonic) -> None:
        self._clock = clock
        self._refused_s: dict[str, deque[float]] = {}
        self._held = 0

    @asynccontextmanager
    async def held_back(self, client: str) -> AsyncIterator[None]:
        """Holds back ServiceError `service_full` of the block, if this client has to wait for it."""
        try:
            yield
        except ServiceError as error:
            if error.code == "service_full" and self._is_impatient(client) and self._held < MOST_HELD:
                self._held += 1
                try:
                    await asyncio.sleep(HELD_S)
                finally:
                    self._held -= 1
            raise

    def _is_impatient(self, client: str) -> bool:
        now_s = self._clock()
        for other, refused_s in list(self._refused_s.items()):
            if refused_s[-1] < now_s - WITHIN_S:
                del self._refused_s[other]
        if client not in self._refused_s and len(self._refused_s) >= MOST_CLIENTS:
            return False
        refused_s = self._refused_s.setdefault(client, deque(maxlen=MOST_PROMPT + 1))
        refused_s.append(now_s)
        return len(refused_s) > MOST_PROMPT and refused_s[0] >= now_s - WITHIN_S


class ServiceTimes:
    """A moving average of job durations in seconds, for Retry-After."""

    def __init__(self) -> None:
        self._mean_s: float | None = None

    @property
    def mean_s(self) -> float:
        return _FIRST_GUESS_S if self._mean_s is None else self._mean_s

    def add(self, took_s: float) -> None:
        self._mean_s = took_s if self._mean_s is None else self._mean_s + _WEIGHT * (took_s - self._mean_s)
