"""Wrong keys, by the address that they come from: who sends too many is refused, but with keys right before."""

from collections import OrderedDict
from collections.abc import Callable
from time import monotonic

from ...errors import TooManyError
from ..clients import MOST_CLIENTS, Rates

WRONG_A_MINUTE = 20


class Guesses:
    """Counts wrong keys, and remembers whose keys were right."""

    def __init__(self, clock: Callable[[], float] = monotonic) -> None:
        self._wrong = Rates(WRONG_A_MINUTE, clock)
        self._right: OrderedDict[tuple[str, str], None] = OrderedDict()

    def told(self, address: str, name: str | None) -> float | None:
        """Of a key that was sent from an address, by the name that it has if it is right: in how many seconds another
        may be tried, None where there have not been too many."""
        if name is not None and (address, name) in self._right:
            self._right.move_to_end((address, name))
            return None
        try:
            self._wrong.take(address, times=name is None)
        except TooManyError as error:
            return error.retry_after_s
        if name is not None:
            self._right[address, name] = None
            while len(self._right) > MOST_CLIENTS:
                self._right.popitem(last=False)
        return None
