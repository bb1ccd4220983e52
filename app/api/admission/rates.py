"""How often an address may ask, for work and for anything, and how often it may send a wrong key.

Counts are kept by address; of more than `MOST_CLIENTS` addresses, those that asked longest ago are forgotten.
"""

import time
from collections import OrderedDict
from collections.abc import Callable
from typing import TypeVar

from ...errors import TooManyError

MOST_CLIENTS = 10_000
WRONG_A_MINUTE = 20
_MINUTE_S = 60.0

Client = TypeVar("Client")
Known = TypeVar("Known")


class Rates:
    """A token bucket for each client."""

    def __init__(self, per_minute: int, clock: Callable[[], float] = time.monotonic) -> None:
        """`per_minute` 0 sets no limit."""
        self._per_minute = per_minute
        self._clock = clock
        self._full_at_s: OrderedDict[str, float] = OrderedDict()

    def take(self, client: str, times: int = 1) -> None:
        """Takes a token; with `times` 0 only checks that there is one. Raises TooManyError `too_many_requests`."""
        if not self._per_minute:
            return
        now_s, each_s = self._clock(), _MINUTE_S / self._per_minute
        full_at_s = max(self._full_at_s.get(client, now_s), now_s) + each_s
        if full_at_s - now_s > _MINUTE_S + 1e-9:
            message = f"more than {self._per_minute} requests a minute from one address; slow down"
            raise TooManyError("too_many_requests", message, retry_after_s=full_at_s - now_s - _MINUTE_S)
        if not times:
            return
        _keep(self._full_at_s, client, full_at_s)


class Frequency:
    """Makes clients wait that ask more than so many times a second, after so many that they may ask at once."""

    def __init__(self, a_second: float, at_once: int, clock: Callable[[], float] = time.monotonic) -> None:
        self._each_s, self._at_once_s = 1 / a_second, at_once / a_second
        self._clock = clock
        self._full_at_s: OrderedDict[str, float] = OrderedDict()

    def wait_s(self, client: str, times: int = 1) -> float:
        """How long this request of a client has to wait; `times` 0 is none yet."""
        now_s = self._clock()
        full_at_s = max(self._full_at_s.get(client, now_s), now_s) + times * self._each_s
        _keep(self._full_at_s, client, full_at_s)
        return max(0.0, full_at_s - now_s - self._at_once_s)


class Guesses:
    """Counts wrong keys by address, and remembers the addresses of right ones."""

    def __init__(self, clock: Callable[[], float] = time.monotonic) -> None:
        self._wrong = Rates(WRONG_A_MINUTE, clock)
        self._right: OrderedDict[tuple[str, str], None] = OrderedDict()

    def wait_s(self, address: str, name: str | None) -> float | None:
        """Records a key from an address (`name` is None if it was wrong); the seconds until another may be tried, None
        if at once."""
        if name is not None and (address, name) in self._right:
            _keep(self._right, (address, name), None)
            return None
        try:
            self._wrong.take(address, times=name is None)
        except TooManyError as error:
            return error.retry_after_s
        if name is not None:
            _keep(self._right, (address, name), None)
        return None


def _keep(found: OrderedDict[Client, Known], client: Client, known: Known) -> None:
    """Keeps what is known of a client as the last, and no more than `MOST_CLIENTS`."""
    found[client] = known
    found.move_to_end(client)
    while len(found) > MOST_CLIENTS:
        found.popitem(last=False)
