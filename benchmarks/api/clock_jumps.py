"""A service whose clocks jump: the time of day by ten years, and all its processes stopped for a while, as when a
machine sleeps.

The time of day is changed for the service alone, by a module that Python imports when it starts; the clock of the
machine is left alone.
"""

import os
import signal
import tempfile
import threading
import time
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager, suppress
from pathlib import Path

import psutil

from .asking import Client
from .bars import Bar
from .disturbed import WORST_HEALTH_S, free_after_s
from .lines import timed_line
from .watching import Running, serving, watching

YEARS_S = 10 * 365 * 86_400.0
JUMPS_S = (YEARS_S, -YEARS_S, 0.0)
STOPPED_S = 3.0
FREED_WITHIN_S = 5.0

_JUMPING = """
import os, pathlib, time

def jumping(real=time.time, offset=pathlib.Path(os.environ["DRILL_CLOCK"])):
    return real() + float(offset.read_text())

time.time = jumping
"""


def clock_jumps() -> Iterator[Bar]:
    """Both jumps, on one service."""
    with ExitStack() as stack:
        offset = stack.enter_context(_jumping(Path(stack.enter_context(tempfile.TemporaryDirectory()))))
        service = stack.enter_context(serving())
        client = stack.enter_context(Client(service.port))
        client.ask_until_taken(timed_line())
        yield from _time_of_day(service, client, offset)
        yield from _asleep(service, client)


@contextmanager
def _jumping(folder: Path) -> Iterator[Path]:
    """The file with the seconds by which the clocks of processes are wrong that are started meanwhile."""
    offset, before = folder / "offset", os.environ.get("PYTHONPATH")
    offset.write_text("0")
    (folder / "sitecustomize.py").write_text(_JUMPING)
    os.environ |= {"PYTHONPATH": os.pathsep.join(filter(None, (str(folder), before))), "DRILL_CLOCK": str(offset)}
    try:
        yield offset
    finally:
        del os.environ["DRILL_CLOCK"], os.environ["PYTHONPATH"]
        os.environ |= {"PYTHONPATH": before} if before is not None else {}


def _time_of_day(service: Running, client: Client, offset: Path) -> Iterator[Bar]:
    statuses, freed_s = list[int](), 0.0
    with watching(service) as enough:
        for jump_s in JUMPS_S:
            offset.write_text(str(jump_s))
            statuses += [client.ask(timed_line()).status for _ in range(4)]
            freed_s = max(freed_s, free_after_s(service, client))
        seen = enough()
    answered = statuses.count(200)
    yield Bar("the time of day jumps: answered", f"{answered} of {len(statuses)}", "all", answered == len(statuses))
    yield Bar("the time of day jumps: free", f"{freed_s:.1f} s", f"{FREED_WITHIN_S:g} s", freed_s <= FREED_WITHIN_S)
    healthy = seen.worst_s <= WORST_HEALTH_S
    yield Bar("the time of day jumps: /healthz", f"{seen.worst_s:.2f} s", f"{WORST_HEALTH_S:g} s", healthy)


def _asleep(service: Running, client: Client) -> Iterator[Bar]:
    """All processes stopped while a line is performed."""
    statuses = list[int]()
    asking = threading.Thread(target=lambda: statuses.append(client.ask(timed_line()).status))
    asking.start()
    time.sleep(0.02)
    _signalled(service, signal.SIGSTOP)
    time.sleep(STOPPED_S)
    _signalled(service, signal.SIGCONT)
    asking.join()
    freed_s = free_after_s(service, client)
    yield Bar(f"all stopped for {STOPPED_S:g} s: the line under way", str(statuses[0]), "200", statuses[0] == 200)
    yield Bar(f"all stopped for {STOPPED_S:g} s: free", f"{freed_s:.1f} s", "5 s", freed_s <= FREED_WITHIN_S)


def _signalled(service: Running, number: signal.Signals) -> None:
    for process in service.family():
        with suppress(psutil.NoSuchProcess):
            process.send_signal(number)
