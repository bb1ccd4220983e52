"""Limits on what a process takes, in processes of the test's own."""

import fcntl
import os
import signal
import time
from multiprocessing import TimeoutError as NotYetError
from multiprocessing import get_context
from pathlib import Path

import pytest

from understudy.api.workers.limits import ProcessorShare, ProcessorTimeError, Turn, processor_time
from understudy.settings import processor_count


def _worked(limit_s: float, busy_s: float, turns: str) -> tuple[int, bool]:
    """The niceness that a process has which works so long, and whether it was stopped."""
    try:
        _work(busy_s, turns, limit_s)
    except ProcessorTimeError:
        return os.nice(0), True
    return os.nice(0), False


def _work(busy_s: float, turns: str, limit_s: float = 60.0) -> None:
    """A message that takes so long of a processor, of a stream that has just begun."""
    with open(turns, "r+b") as file, processor_time(limit_s, ProcessorShare(file.fileno())):
        _be_busy(busy_s)


def _be_busy(busy_s: float) -> None:
    ends_s = time.process_time() + busy_s
    while time.process_time() < ends_s:
        pass


@pytest.fixture
def turns(tmp_path: Path) -> str:
    """The file by which processes take turns."""
    path = tmp_path / "turns"
    path.touch()
    return str(path)


@pytest.mark.parametrize(
    ("limit_s", "busy_s", "niceness", "stopped"),
    [(30.0, 0.01, os.nice(0), False), (2.0, 0.5, 19, False), (0.2, 1.0, 19, True)],
)
def test_who_takes_long_gives_way_and_then_is_stopped(
    limit_s: float, busy_s: float, niceness: int, stopped: bool, turns: str
) -> None:
    with get_context("spawn").Pool(1) as pool:
        assert pool.apply(_worked, (limit_s, busy_s, turns)) == (niceness, stopped)


def _lasted(busy_s: float, turns: str) -> float:
    """Seconds by the clock for each of the processor's, in a message that may take long."""
    began_s = time.monotonic()
    _work(busy_s, turns)
    return (time.monotonic() - began_s) / busy_s


def test_who_takes_more_than_a_moment_rests_in_between(turns: str) -> None:
    """Of half a second of work, .4 s is in slices of .05, each after as long a rest."""
    with get_context("spawn").Pool(1) as pool:
        assert pool.apply(_lasted, (0.5, turns)) > 1.4


def _worked_in_turns(busy_s: float, turns: str) -> float:
    """When a message that works so long is done."""
    _work(busy_s, turns)
    return time.monotonic()


@pytest.mark.parametrize(("busy_s", "together_s"), [(0.6, 2.9), (0.09, 0.18)])
def test_of_those_that_take_long_one_works_at_a_time(busy_s: float, together_s: float, turns: str) -> None:
    """Each of three has .5 s in slices with rests, and .03 to .07 s of brief work beside no other's."""
    processes = 3 * max(1, processor_count() // 2)
    with get_context("fork").Pool(processes) as pool:  # they begin at the same time, without imports
        began_s = time.monotonic()
        ended_s = pool.starmap(_worked_in_turns, [(busy_s, turns)] * processes, chunksize=1)
    assert max(ended_s) - began_s > together_s


def test_who_dies_in_its_turn_gives_it_up(turns: str) -> None:
    dying = get_context("spawn").Process(target=_die_in_turn, args=(turns,))
    dying.start()
    dying.join()
    assert _worked_in_turns(0.2, turns) > 0


def _die_in_turn(turns: str) -> None:
    with open(turns, "r+b") as file:
        fcntl.lockf(file, fcntl.LOCK_EX)
        os.kill(os.getpid(), signal.SIGKILL)


def test_brief_work_does_not_wait_for_long_work(turns: str) -> None:
    """Another stream rests within its turn of long work; who has saved up enough works meanwhile."""
    with open(turns, "r+b") as file, get_context("fork").Pool(1) as pool:
        for place in range(Turn.LONG, 2 * processor_count(), len(Turn)):
            fcntl.lockf(file, fcntl.LOCK_EX, 1, place)
        assert pool.apply_async(_worked_in_turns, (0.09, turns)).get(timeout=20.0)
        with pytest.raises(NotYetError):
            pool.apply_async(_worked_in_turns, (0.2, turns)).get(timeout=0.5)


@pytest.mark.parametrize(
    ("heard_each_s", "is_earned"), [(1.0, True), (3.0, False), (0.0, False)], ids=["a voice", "ahead", "silent"]
)
def test_sound_earns_processor_time_unless_it_is_ahead_of_the_clock(
    heard_each_s: float, is_earned: bool, turns: str
) -> None:
    """A third of a core, for a second by the clock."""
    with open(turns, "r+b") as file:
        pace = ProcessorShare(file.fileno())
        for passed_s in (0.1 * piece for piece in range(11)):
            pace.end(0.033)
            pace.earn(heard_each_s * passed_s, passed_s)
            pace.begin()
        assert (pace.turn is None) is is_earned


def test_afterwards_there_is_no_limit(turns: str) -> None:
    before = signal.getsignal(signal.SIGPROF)
    try:
        _work(0.0, turns, 5.0)
        assert signal.getitimer(signal.ITIMER_PROF) == (0.0, 0.0)
    finally:
        signal.signal(signal.SIGPROF, before)
