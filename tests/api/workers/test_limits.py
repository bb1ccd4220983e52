"""Limits on what a process takes, in processes of the test's own."""

import os
import signal
import time
from multiprocessing import get_context

import pytest

from understudy.api.workers.limits import ProcessorTimeError, processor_time


def _worked(limit_s: float, busy_s: float) -> tuple[int, bool]:
    """The niceness that a process has which works so long, and whether it was stopped."""
    try:
        with processor_time(limit_s):
            ends_s = time.process_time() + busy_s
            while time.process_time() < ends_s:
                pass
    except ProcessorTimeError:
        return os.nice(0), True
    return os.nice(0), False


@pytest.mark.parametrize(
    ("limit_s", "busy_s", "niceness", "stopped"),
    [(30.0, 0.01, os.nice(0), False), (2.0, 0.5, 19, False), (0.2, 1.0, 19, True)],
)
def test_who_takes_long_gives_way_and_then_is_stopped(
    limit_s: float, busy_s: float, niceness: int, stopped: bool
) -> None:
    with get_context("spawn").Pool(1) as pool:
        assert pool.apply(_worked, (limit_s, busy_s)) == (niceness, stopped)


def _lasted(busy_s: float) -> float:
    """Seconds by the clock for each of the processor's, in a message that may take long."""
    began_s = time.monotonic()
    _worked(60.0, busy_s)
    return (time.monotonic() - began_s) / busy_s


def test_who_takes_more_than_a_moment_rests_in_between() -> None:
    """Half a second of work has .3 s in slices of .05, each followed by .35 s of rest."""
    with get_context("spawn").Pool(1) as pool:
        assert pool.apply(_lasted, (0.5,)) > 4.0


def test_afterwards_there_is_no_limit() -> None:
    before = signal.getsignal(signal.SIGPROF)
    try:
        with processor_time(5.0):
            pass
        assert signal.getitimer(signal.ITIMER_PROF) == (0.0, 0.0)
    finally:
        signal.signal(signal.SIGPROF, before)
