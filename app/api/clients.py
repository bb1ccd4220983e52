"""How often one client may ask: so many requests a minute, at most as many at once, by its address.

Of more clients than `MOST_CLIENTS` those are forgotten that asked longest ago.
"""

import time
from collections import OrderedDict
from collections.abc import Callable

from ..errors import TooManyError

MOST_CLIENTS = 10_000
_MINUTE_S = 60.0


class Rates:
    """A bucket of requests for each client, which fills evenly."""

    def __init__(self, per_minute: int, clock: Callable[[], float] = time.monotonic) -> None:
        """`per_minute` 0 lets everything pass."""
        self._per_minute = per_minute
        self._clock = clock
        self._full_at_s: OrderedDict[str, float] = OrderedDict()

    def take(self, client: str, times: int = 1) -> None:
        """Counts a request; of one that counts 0 `times`, whether another could be made. Raises TooManyError
        `too_many_requests`."""
        if not self._per_minute:
            return
        now_s, each_s = self._clock(), _MINUTE_S / self._per_minute
        full_at_s = max(self._full_at_s.get(client, now_s), now_s) + each_s
        if full_at_s - now_s > _MINUTE_S + 1e-9:
            message = f"more than {self._per_minute} requests a minute from one address; ask more slowly"
            raise TooManyError("too_many_requests", message, retry_after_s=full_at_s - now_s - _MINUTE_S)
        if not times:
            return
        self._full_at_s[client] = full_at_s
        self._full_at_s.move_to_end(client)
        while len(self._full_at_s) > MOST_CLIENTS:
            self._full_at_s.popitem(last=False)
