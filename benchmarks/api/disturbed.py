"""How a service stands a disturbance: `/healthz` meanwhile, honest requests meanwhile against before, and how soon
afterwards its places are free again: a line is performed and a live stream begun.
"""

import time
from collections.abc import Iterator
from contextlib import suppress

from .asking import Client
from .bars import Bar
from .disturbances import DISTURBANCES, Disturbance
from .lines import timed_line
from .raw_streams import LARGEST_RECEIVED, opened
from .watching import Running, Watched, percentile, serving, watching

ASKED = 8
WORST_HEALTH_S, MOST_SLOWER, FREED_WITHIN_S = 0.2, 2.0, 5.0
PATIENCE_S = 90.0


def disturbed(only: str = "") -> Iterator[Bar]:
    """Each disturbance that has `only` in its name, one after the other, on one service."""
    with serving() as service, Client(service.port) as client:
        _honest_s(client, 2 * ASKED)
        for each in DISTURBANCES:
            if only in each.name:
                yield from _stood(each, service, client)


def _stood(disturbance: Disturbance, service: Running, client: Client) -> Iterator[Bar]:
    before_s = _honest_s(client, ASKED)
    with watching(service) as enough:
        with disturbance.begin(service):
            during_s = _honest_s(client, ASKED)
        seen = enough()
    freed_s = free_after_s(service, client)
    print(_row(disturbance, seen, during_s / before_s, freed_s), flush=True)
    slower, worst_s = during_s / before_s, seen.worst_s
    yield Bar(f"{disturbance.name}: /healthz", f"{worst_s:.2f} s", f"{WORST_HEALTH_S:g} s", worst_s <= WORST_HEALTH_S)
    yield Bar(f"{disturbance.name}: honest requests", f"{slower:.1f} x", f"{MOST_SLOWER:g} x", slower <= MOST_SLOWER)
    yield Bar(f"{disturbance.name}: free", f"{freed_s:.1f} s", f"{FREED_WITHIN_S:g} s", freed_s <= FREED_WITHIN_S)


def _row(disturbance: Disturbance, seen: Watched, slower: float, freed_s: float) -> str:
    health = f"/healthz {seen.worst_s * 1000:6.0f} ms"
    return f"  {disturbance.name:40s} {health}, honest requests {slower:5.1f} x, free after {freed_s:5.1f} s"


def _honest_s(client: Client, times: int) -> float:
    """The median of how long a line takes, waiting to be let in included."""
    took_s = []
    for _ in range(times):
        began_s = time.monotonic()
        client.ask_until_taken(timed_line())
        took_s.append(time.monotonic() - began_s)
    return percentile(tuple(took_s), 50)


def free_after_s(service: Running, client: Client) -> float:
    """How long until a line is performed and a stream begun."""
    began_s = time.monotonic()
    while time.monotonic() - began_s < PATIENCE_S:
        if client.ask(timed_line()).status == 200 and _begins(service):
            break
        time.sleep(0.1)
    return time.monotonic() - began_s


def _begins(service: Running) -> bool:
    with suppress(OSError), opened(service.port) as stream:
        stream.settimeout(PATIENCE_S)
        return b'"ready"' in stream.recv(LARGEST_RECEIVED)
    return False
