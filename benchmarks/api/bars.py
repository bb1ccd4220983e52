"""The requirements on the service, the measured values, and whether they suffice."""

from collections.abc import Iterator
from dataclasses import dataclass

from .watching import Watched


@dataclass(frozen=True, slots=True)
class Bar:
    """What was asked for, what was measured, and whether that is enough."""

    what: str
    measured: str
    floor: str
    met: bool

    def __str__(self) -> str:
        return f"| {self.what} | {self.measured} | {self.floor} | {'met' if self.met else 'MISSED'} |"


def watched(during: str, seen: Watched) -> Iterator[Bar]:
    """The bars of what was seen from outside."""
    worst_ms = seen.worst_s * 1000
    yield Bar(f"/healthz worst, {during}", f"{worst_ms:.0f} ms", "200 ms", worst_ms <= 200)
    yield Bar(f"memory of the service, {during}", f"{seen.peak_mb:.0f} MB", "1500 MB", seen.peak_mb <= 1500)
