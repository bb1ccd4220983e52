"""Values that are loaded on first use."""

from collections.abc import Callable
from contextvars import copy_context
from threading import Lock
from typing import Generic, TypeVar

Value = TypeVar("Value")


class OnDemand(Generic[Value]):
    """A value made on first use, once, whichever threads ask for it, in the context (contextvars) in which this was
    created. If making it raises, the next call tries again."""

    __slots__ = ("_context", "_lock", "_made", "_make")

    def __init__(self, make: Callable[[], Value]) -> None:
        self._make = make
        self._context = copy_context()
        self._made: tuple[Value] | None = None
        self._lock = Lock()

    @classmethod
    def ready(cls, value: Value) -> "OnDemand[Value]":
        """A value that is made already."""
        found = cls(lambda: value)
        found._made = (value,)
        return found

    def get(self) -> Value:
        """The value; raises what making it raises."""
        with self._lock:
            if self._made is None:
                self._made = (self._context.run(self._make),)
            return self._made[0]

    def made(self) -> Value | None:
        """The value if it has been made, else None."""
        return self._made[0] if self._made else None
