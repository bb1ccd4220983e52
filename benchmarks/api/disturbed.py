"""How a service stands a disturbance: `/healthz` meanwhile, honest requests meanwhile against before, and how soon
afterwards its places are free again: a line is performed and a live stream begun.

Honest requests are lines of five seconds as they usually come, aligned and not seen before, one after the other, from
the moment at which the disturbance begins. What counts is their median; where setting it up takes long, that of those
asked meanwhile or of those asked afterwards, whichever is slower. (Until 28 November eight lines of .03 s, with the
times of their words, were asked for when all was set up: a quarter of a second, which said how the service stood the
beginning of what lasts, and nothing of the filling of streams, which takes longest.) Who disturbs is a process of its
own: as threads of the one that asks, they held its interpreter, and it waited for itself.
"""

import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from multiprocessing import get_context
from multiprocessing.synchronize import Event

from .asking import Client
from .bars import Bar
from .disturbances import DISTURBANCES, Disturbance
from .lines import line_of, timed_line
from .raw_streams import LARGEST_RECEIVED, opened
from .watching import Running, Watched, percentile, serving, watching

ASKED, HONEST_S = 16, 5.0
WORST_HEALTH_S, MOST_SLOWER, FREED_WITHIN_S = 0.2, 2.0, 5.0
PATIENCE_S = 90.0


def disturbed(only: str = "") -> Iterator[Bar]:
    """Each disturbance that has `only` in its name, one after the other, on one service."""
    with serving() as service, Client(service.port) as client:
        _honest_s(client, ASKED)
        for each in DISTURBANCES:
            if only in each.name:
                yield from _stood(each, service, client)


def _stood(disturbance: Disturbance, service: Running, client: Client) -> Iterator[Bar]:
    before_s = percentile(_honest_s(client, ASKED), 50)
    with watching(service) as enough:
        with _disturbing(disturbance, service) as is_set_up:
            at_first_s = _honest_s(client, 1, until=is_set_up)
            later_s = _honest_s(client, ASKED)
        seen = enough()
    freed_s, worst_s = free_after_s(service, client), seen.worst_s
    parts = (at_first_s, later_s) if len(at_first_s) >= ASKED else (at_first_s + later_s,)
    slower = max(percentile(each, 50) for each in parts) / before_s
    slowest = max(at_first_s + later_s) / before_s
    print(_row(disturbance, seen, slower, slowest, freed_s), flush=True)
    yield Bar(f"{disturbance.name}: /healthz", f"{worst_s:.2f} s", f"{WORST_HEALTH_S:g} s", worst_s <= WORST_HEALTH_S)
    yield Bar(f"{disturbance.name}: honest requests", f"{slower:.1f} x", f"{MOST_SLOWER:g} x", slower <= MOST_SLOWER)
    yield Bar(f"{disturbance.name}: free", f"{freed_s:.1f} s", f"{FREED_WITHIN_S:g} s", freed_s <= FREED_WITHIN_S)


def _row(disturbance: Disturbance, seen: Watched, slower: float, slowest: float, freed_s: float) -> str:
    health = f"/healthz {seen.worst_s * 1000:6.0f} ms"
    honest = f"honest requests {slower:5.1f} x, {slowest:4.1f} x at worst"
    return f"  {disturbance.name:42s} {health}, {honest}, free after {freed_s:5.1f} s"


@contextmanager
def _disturbing(disturbance: Disturbance, service: Running) -> Iterator[Callable[[], bool]]:
    """Goes on in a process of its own until the block ends; the function says whether it is set up. Raises RuntimeError
    if it ended otherwise."""
    fork = get_context("fork")  # nothing else runs in this process, and an attacker's imports would take a core
    set_up, enough = fork.Event(), fork.Event()
    attacker = fork.Process(target=_disturb, args=(disturbance, service, set_up, enough))
    attacker.start()
    try:
        yield lambda: set_up.is_set() or not attacker.is_alive()
    finally:
        enough.set()
        attacker.join(PATIENCE_S)
        attacker.kill()
    if attacker.exitcode:
        raise RuntimeError(f"{disturbance.name}: ended with {attacker.exitcode}")


def _disturb(disturbance: Disturbance, service: Running, set_up: Event, enough: Event) -> None:
    with disturbance.begin(service):
        set_up.set()
        enough.wait()


def _honest_s(client: Client, least: int, *, until: Callable[[], bool] = lambda: True) -> tuple[float, ...]:
    """How long each of so many lines takes, or of more until something holds, waiting to be let in included."""
    took_s, line = list[float](), line_of(HONEST_S)
    while len(took_s) < least or not until():
        began_s = time.monotonic()
        client.ask_until_taken(line)
        took_s.append(time.monotonic() - began_s)
    return tuple(took_s)


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
