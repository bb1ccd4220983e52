"""Limits on what a process takes, in processes of the test's own."""

import fcntl
import os
import signal
import time
from multiprocessing import get_context
from pathlib import Path

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
    """Of half a second of work, .4 s is in slices of .05, each followed by as long a rest."""
    with get_context("spawn").Pool(1) as pool:
        assert pool.apply(_lasted, (0.5,)) > 1.4


def _worked_in_turns(turns: str) -> float:
    """When a message that works for .6 s is done."""
    with open(turns, "r+b") as file, processor_time(60.0, turns=file.fileno()):
        ends_s = time.process_time() + 0.6
        while time.process_time() < ends_s:
            pass
    return time.monotonic()


def test_of_those_that_take_long_one_works_at_a_time(tmp_path: Path) -> None:
    """Three have .5 s in slices each, all but the first rest in their turns: together 2.85 s."""
    turns = tmp_path / "turns"
    turns.touch()
    with get_context("spawn").Pool(3) as pool:
        pool.map(time.sleep, [0.01] * 3)
        began_s = time.monotonic()
        ended_s = pool.map(_worked_in_turns, [str(turns)] * 3, chunksize=1)
    assert max(ended_s) - began_s > 2.8


def test_who_dies_in_its_turn_gives_it_up(tmp_path: Path) -> None:
    turns = tmp_path / "turns"
    turns.touch()
    dying = get_context("spawn").Process(target=_die_in_turn, args=(str(turns),))
    dying.start()
    dying.join()
    assert _worked_in_turns(str(turns)) > 0


def _die_in_turn(turns: str) -> None:
    with open(turns, "r+b") as file:
        fcntl.lockf(file, fcntl.LOCK_EX)
        os.kill(os.getpid(), signal.SIGKILL)


def test_afterwards_there_is_no_limit() -> None:
    before = signal.getsignal(signal.SIGPROF)
    try:
        with processor_time(5.0):
            pass
        assert signal.getitimer(signal.ITIMER_PROF) == (0.0, 0.0)
    finally:
        signal.signal(signal.SIGPROF, before)
